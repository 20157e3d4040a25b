import { expect, it } from 'vitest';
import { setValue } from '../../src/document/edits.ts';
import { Moments } from '../../src/evaluation/moments.ts';
import { openSwinging } from '../support/swinging-actor.ts';

function open() {
  const opened = openSwinging();
  const { store, session, evaluations } = opened;
  return { ...opened, moments: new Moments(store, session, evaluations) };
}

it('are bit for bit what is shown at their time, and leave the present as it is', () => {
  const { session, actor, evaluations, moments } = open();
  for (const time of [0, 0.125, 0.7, 1, 1.25, -0.5]) {
    session.clipTime.value = 0.375;
    const present = evaluations.of(actor()).vertices().positions.slice();
    const other = moments.at('ghost', actor(), time);
    const ghost = {
      joints: other.characterFromJoint.slice(),
      ...{
        positions: other.vertices().positions.slice(),
        normals: other.vertices().normals.slice(),
      },
    };
    expect(evaluations.of(actor()).vertices().positions).toEqual(present);
    session.clipTime.value = time;
    const shown = evaluations.of(actor());
    expect(ghost.joints).toEqual(shown.characterFromJoint);
    expect(ghost.positions).toEqual(shown.vertices().positions);
    expect(ghost.normals).toEqual(shown.vertices().normals);
  }
});

it('do not have what is not keyed, which belongs to the present', () => {
  const { store, session, actor, evaluations, moments } = open();
  session.clipTime.value = 0.5;
  const keyed = evaluations.of(actor()).pose.q.slice();
  const swung = keyed.findIndex((value, at) => value !== actor().q[at]);
  store.dispatch(setValue(actor().id, keyed, swung, 0.125, 'turn'));
  expect(evaluations.of(actor()).pose.q[swung]).toBe(0.125);
  expect(moments.at('ghost', actor(), 0.5).pose.q).toEqual(keyed);
});

it('keep their evaluations while they are in use, and make others afterwards', () => {
  const { actor, moments } = open();
  const first = moments.at('one', actor(), 0.5);
  const second = moments.at('two', actor(), 0.5);
  expect(moments.at('one', actor(), 0.75)).toBe(first);
  moments.keepOnly(['two']);
  expect(moments.at('two', actor(), 0.75)).toBe(second);
  expect(moments.at('one', actor(), 0.5)).not.toBe(first);
});
