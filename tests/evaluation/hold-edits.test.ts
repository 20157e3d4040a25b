import { expect, it } from 'vitest';
import { bindClip, setMorphWeight, setValue } from '../../src/document/edits.ts';
import { openSwinging } from '../support/swinging-actor.ts';

function open() {
  const { session, evaluations, ...opened } = openSwinging();
  session.clipTime.value = 0.5;
  return { ...opened, session, shown: () => evaluations.of(opened.actor()).pose };
}

it('shows an edited value over the clip, and the others as the clip has them', () => {
  const { store, session, actor, shown } = open();
  const before = store.scene.value;
  const clipped = shown().q.slice();
  const swung = clipped.findIndex((value, at) => value !== actor().q[at]);
  store.dispatch(setValue(actor().id, clipped, swung, 0.125, 'turn'));
  expect(actor().unkeyed).toEqual({ time: 0.5, values: [swung], morphs: [], pins: [] });
  session.clipTime.value = 0.75;
  expect(shown().q[swung]).toBe(0.125);
  expect(actor().clip).toBe(0);
  store.undo();
  expect(store.scene.value).toBe(before);
  expect(shown().q[swung]).toBe(0.75);
});

it('adds to what is unkeyed already, and forgets it when another clip is bound', () => {
  const { store, actor, shown } = open();
  const { id } = actor();
  store.dispatch(setValue(id, shown().q, 3, 0.25, 'turn'));
  store.dispatch(setValue(id, shown().q, 1, 0.5, 'turn'));
  expect(actor().unkeyed?.values).toEqual([1, 3]);
  if (actor().morphWeights.length > 0) {
    store.dispatch(setMorphWeight(id, shown().morphWeights, 0, 0.5, 'shape'));
    expect(actor().unkeyed?.morphs).toEqual([0]);
  }
  store.amend(bindClip(id, null));
  expect(actor().unkeyed).toBeNull();
});
