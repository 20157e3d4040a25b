import { expect, it } from 'vitest';
import { forwardKinematics } from '../../src/core/forward-kinematics.ts';
import { setKey } from '../../src/core/motion/edit/set-key.ts';
import { editClip } from '../../src/document/clip-edits.ts';
import { bindClip } from '../../src/document/edits.ts';
import { keyMovedPose } from '../../src/document/key-pose.ts';
import { openCharacter } from '../../src/document/open-characters.ts';
import { MotionView } from '../../src/document/motion-view.ts';
import { boundClip } from '../../src/document/scene.ts';
import { Session } from '../../src/document/session.ts';
import { Store } from '../../src/document/store.ts';
import { changedSpan } from '../../src/evaluation/changed-span.ts';
import { Evaluations } from '../../src/evaluation/evaluations.ts';
import { Moments } from '../../src/evaluation/moments.ts';
import { Trails } from '../../src/evaluation/trails.ts';
import { ChainDrag } from '../../src/posing/ik/chain-drag.ts';
import { placeOf } from '../../src/posing/ik/chain-problem.ts';
import { ikMethods } from '../../src/posing/ik/methods.ts';
import { naturesInUse } from '../../src/posing/natural/natures-in-use.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { rotatedTree } from '../fixtures/rigs.ts';
import { swingOf } from '../fixtures/swing.ts';
import { allThere } from '../support/kernels.ts';

function open() {
  const store = new Store();
  const session = new Session();
  const evaluations = new Evaluations(store, session, allThere);
  const made = characterOfRig(rotatedTree());
  const character = { ...made, clips: [swingOf(made)] };
  store.dispatch(openCharacter(null, character, 'linear-blend'));
  const actor = () => store.scene.value.actors[0]!;
  store.dispatch(bindClip(actor().id, 0));
  const moments = new Moments(store, session, evaluations);
  const joint = character.skeleton.jointOfSource[character.skeleton.jointCount - 1]!;
  return { store, session, actor, evaluations, moments, trails: new Trails(moments), joint };
}

const settings = new MotionView().trails.value;

it('leads through where forward kinematics has the joint at each frame', () => {
  const { actor, evaluations, session, trails, joint } = open();
  const [trail] = trails.of(actor(), [joint], settings, 0);
  expect(trail!.frames).toHaveLength(31);
  expect(trail!.keys.map(({ time }) => time)).toEqual([0, 1]);
  const { skeleton } = actor().character;
  for (const { time, place } of trail!.frames) {
    session.clipTime.value = time;
    const joints = new Float64Array(skeleton.jointCount * 16);
    forwardKinematics(skeleton, evaluations.of(actor()).pose.q, joints);
    expect(place).toEqual(placeOf(joints, joint, trail!.point));
  }
});

it('shows some frames about the present, within the clip', () => {
  const { actor, trails, joint } = open();
  const [trail] = trails.of(actor(), [joint], { ...settings, frames: 4 }, 0.1);
  expect(trail!.frames.map(({ time }) => Math.round(time * 30))).toEqual([0, 1, 2, 3, 4, 5, 6, 7]);
});

it('is the same after an edit as one that is computed anew', () => {
  const { store, actor, moments, trails, joint } = open();
  trails.of(actor(), [joint], settings, 0);
  const { target } = boundClip(actor())!.channels[0]!;
  for (const [time, value] of [
    [0.5, 0.2],
    [0.25, -1],
    [0.75, 1],
    [0.6, 0.3],
    [0.9, 2],
  ] as const) {
    store.dispatch(editClip(actor().id, 0, 'key', (clip) => setKey(clip, target!, time, value)));
    const fresh = new Trails(moments).of(actor(), [joint], settings, 0);
    expect(trails.of(actor(), [joint], settings, 0)).toEqual(fresh);
  }
});

it('knows how far the change of a key reaches', () => {
  const { actor } = open();
  const clip = boundClip(actor())!;
  const { target } = clip.channels[0]!;
  const times = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8];
  const many = times.reduce((made, time) => setKey(made, target!, time, time * time), clip);
  expect(changedSpan(many, many)).toEqual([Infinity, -Infinity]);
  expect(changedSpan(many, setKey(many, target!, 0.4, 7))).toEqual([0.2, 0.6]);
  expect(changedSpan(many, setKey(many, target!, 0.1, 7))[0]).toBe(-Infinity);
});

it('follows a key that is dragged: the joint is there at that time, and undo restores the bytes', async () => {
  const { store, actor, moments, trails, joint } = open();
  const before = store.scene.value;
  const [trail] = trails.of(actor(), [joint], settings, 0);
  const { skeleton } = actor().character;
  const moment = moments.at('drag', actor(), 1);
  const shown = { ...moment.snapshot(), pins: moment.pins };
  const solver = await ikMethods.find(({ id }) => id === 'dls')!.load();
  const natures = naturesInUse(actor().character, actor().natures);
  const { point } = trail!;
  // A place that the point can reach: where it is at another time.
  const target = trail!.frames[12]!.place;
  const drag = new ChainDrag({
    ...{ skeleton, q: shown.q, joint, point, held: [], natures, count: 2, solver, seconds: 0 },
  });
  drag.aim(target, 0);
  const { q } = drag.finish();
  store.dispatch(keyMovedPose(actor(), { time: 1, before: shown, q, around: [0] }, 'Move a key'));
  const [after] = trails.of(actor(), [joint], settings, 0);
  const moved = after!.keys.find(({ time }) => time === 1)!.place;
  expect(Math.hypot(...moved.map((value, i) => value - target[i]!))).toBeLessThan(1e-3);
  expect(after!.keys.find(({ time }) => time === 0)!.place).toEqual(trail!.keys[0]!.place);
  expect(store.history.value.past.at(-1)!.label).toBe('Move a key');
  store.undo();
  expect(store.scene.value).toBe(before);
});
