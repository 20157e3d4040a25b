import fc from 'fast-check';
import { vec3 } from 'gl-matrix';
import { describe, expect, it } from 'vitest';
import { diagonal } from '../../src/core/bounds.ts';
import { removeActor, setPose, setValue } from '../../src/document/edits.ts';
import { withoutCircles } from '../../src/document/followers.ts';
import {
  followJoint,
  holdRotation,
  movePin,
  pinJoints,
  pinOf,
  setPinWeight,
  unpinJoints,
  whyNoFollowing,
} from '../../src/document/pin-edits.ts';
import { setTransform } from '../../src/document/place-edits.ts';
import { reconcile } from '../../src/document/reconcile.ts';
import { openCharacter } from '../../src/document/open-characters.ts';
import { type Actor, unmoved } from '../../src/document/scene.ts';
import { Session } from '../../src/document/session.ts';
import { Store } from '../../src/document/store.ts';
import { Evaluations } from '../../src/evaluation/evaluations.ts';
import { Evaluator } from '../../src/evaluation/evaluator.ts';
import { settlePins } from '../../src/evaluation/settle-pins.ts';
import type { Vector3 } from '../../src/posing/ik/problem.ts';
import type { Pin } from '../../src/posing/pins/pin.ts';
import { applyPins } from '../../src/posing/pins/pin-layer.ts';
import { jointRotation, pinnedPoint } from '../../src/posing/pins/pin-target.ts';
import { readBundled } from '../support/bundled.ts';
import { allThere, fullPool } from '../support/kernels.ts';
import { layerInput } from '../support/layer-input.ts';

const human = await readBundled('human');
const { skeleton } = human;
const jointNamed = (name: string): number => {
  const joint = skeleton.names.indexOf(name);
  if (joint < 0) throw new Error(`${name}: ${skeleton.names.join(', ')}`);
  return joint;
};

function open(count: number) {
  const session = new Session();
  const store = new Store((before, after) => reconcile(session, before, after));
  const evaluations = new Evaluations(store, session, allThere);
  store.settle = (scene) => settlePins(scene, evaluations);
  for (let i = 0; i < count; i++) store.dispatch(openCharacter(null, human, 'linear-blend'));
  const actor = (at = 0): Actor => store.scene.value.actors[at]!;
  const shown = (at = 0) => evaluations.of(actor(at));
  /** Where a joint is in the scene. */
  const placeOf = (at: number, joint: number, point: vec3 = [0, 0, 0]): vec3 => {
    const { characterFromJoint, display } = shown(at);
    const place = vec3.transformMat4(
      [0, 0, 0],
      point,
      characterFromJoint.subarray(joint * 16, joint * 16 + 16),
    );
    return vec3.transformMat4(place, place, display.sceneFromCharacter);
  };
  return { session, store, evaluations, actor, shown, placeOf };
}

const [leftFoot, rightFoot, leftHand, rightHand] = [
  'Left foot',
  'Right foot',
  'Left hand',
  'Right hand',
].map(jointNamed) as [number, number, number, number];

/** (qCount) whether the bits of two poses are the same. */
const sameBits = (a: Float64Array, b: Float64Array): boolean =>
  a.length === b.length && a.every((value, i) => Object.is(value, b[i]));

/** The length of the chain from the hip to the foot, in the scene. */
const legLength = (() => {
  const { shown, placeOf } = open(1);
  const parent = (joint: number): number => skeleton.parents[joint]!;
  const joints = [leftFoot, parent(leftFoot), parent(parent(leftFoot))];
  expect(shown().state.pins).toEqual([]);
  const [foot, knee, hip] = joints.map((joint) => placeOf(0, joint));
  return vec3.distance(foot!, knee!) + vec3.distance(knee!, hip!);
})();

/** A part of the chain's length. */
const pinTolerance = 1e-3;

const change = fc.record({
  index: fc.nat(skeleton.qRest.length - 1),
  value: fc.double({ min: -0.6, max: 0.6, noNaN: true }),
});

describe('a pinned joint', () => {
  it('stays where it is while the pelvis moves and turns, sliders are moved, and steps follow', () => {
    const pelvis = fc.record({
      index: fc.integer({ min: 0, max: 5 }),
      value: fc.double({ min: -0.15, max: 0.15, noNaN: true }),
    });
    fc.assert(
      fc.property(fc.array(pelvis, { minLength: 1, maxLength: 4 }), (steps) => {
        const { store, shown, actor, placeOf } = open(1);
        store.dispatch(pinJoints(shown(), [leftFoot, rightFoot]));
        const before = [leftFoot, rightFoot].map((joint) => placeOf(0, joint));
        for (const { index, value } of steps) {
          const gesture = store.begin('Move the pelvis');
          const start = shown().poseToEdit.q.slice();
          gesture.preview(setValue(actor().id, start, index, value, 'Move'));
          gesture.commit();
          for (const [i, joint] of [leftFoot, rightFoot].entries()) {
            expect(vec3.distance(placeOf(0, joint), before[i]!)).toBeLessThan(
              pinTolerance * legLength,
            );
          }
        }
      }),
      { numRuns: 8 },
    );
  });

  it('keeps its orientation too, if that is held', () => {
    const { store, shown, actor } = open(1);
    store.dispatch(pinJoints(shown(), [leftFoot]));
    store.dispatch(holdRotation(shown(), leftFoot, true));
    const before = jointRotation(leftFoot, shown().characterFromJoint);
    store.dispatch(setValue(actor().id, shown().poseToEdit.q, 1, -0.1, 'Lower'));
    const after = jointRotation(leftFoot, shown().characterFromJoint);
    const dot = before.reduce((sum, value, i) => sum + value * after[i]!, 0);
    expect(2 * Math.acos(Math.min(1, Math.abs(dot)))).toBeLessThan(0.01);
  });

  it('changes no bit where it holds, whether or not it can hold at all', () => {
    fc.assert(
      fc.property(
        fc.array(change, { minLength: 1, maxLength: 6 }),
        fc.tuple(...Array.from({ length: 3 }, () => fc.double({ min: -2, max: 2, noNaN: true }))),
        (changes, far) => {
          const { store, shown, actor } = open(1);
          store.dispatch(pinJoints(shown(), [leftFoot, rightHand]));
          store.dispatch(movePin(actor(), rightHand, [far[0]!, far[1]!, far[2]!]));
          const q = actor().q.slice();
          for (const { index, value } of changes) q[index] = value;
          store.dispatch(setPose(actor().id, q));
          // The step wrote what was shown, and from there nothing moves.
          expect(sameBits(shown().poseToEdit.q, actor().q)).toBe(true);
          const again = solved(actor(), actor().q);
          expect(sameBits(again, actor().q)).toBe(true);
        },
      ),
      { numRuns: 6 },
    );
  });

  it('does nothing with weight 0, bit for bit', () => {
    const { store, shown, actor } = open(1);
    store.dispatch(pinJoints(shown(), [leftHand]));
    store.dispatch(setPinWeight(actor(), leftHand, 0));
    const q = actor().q.map((value) => value + 0.3);
    store.dispatch(setPose(actor().id, q));
    expect(sameBits(actor().q, q)).toBe(true);
    expect(sameBits(shown().pose.q, q)).toBe(true);
  });

  it('is held the harder the more it weighs', () => {
    const residual = (weight: number): number => {
      const { store, shown, actor } = open(1);
      store.dispatch(pinJoints(shown(), [leftHand, rightHand]));
      const { place } = pinOf(actor(), leftHand)!;
      const far: Vector3 = [place[0] + diagonal(human.bounds), place[1], place[2]];
      store.dispatch(setPinWeight(actor(), leftHand, weight));
      store.dispatch(movePin(actor(), leftHand, far));
      const pin = pinOf(actor(), leftHand)!;
      return vec3.distance([...pinnedPoint(pin, shown().characterFromJoint)], [...far]);
    };
    expect(residual(1)).toBeLessThan(residual(0.1));
  });

  it('depends on actor and moment alone, whatever was shown before', () => {
    const { store, shown, actor, evaluations } = open(1);
    store.dispatch(pinJoints(shown(), [leftFoot, leftHand]));
    const gesture = store.begin('Move');
    const start = shown().poseToEdit.q.slice();
    for (const value of [0.02, 0.1, -0.2, -0.1]) {
      gesture.preview(setValue(actor().id, start, 1, value, 'Move'));
      expect(shown().pose.q).toHaveLength(start.length);
    }
    const fresh = new Evaluator(actor(), fullPool()).evaluate(actor(), 0);
    expect(sameBits(fresh.pose.q, evaluations.of(actor()).pose.q)).toBe(true);
    gesture.cancel();
    expect(sameBits(shown().pose.q, start)).toBe(true);
  });

  it('is let go without a move', () => {
    const { store, shown, actor } = open(1);
    store.dispatch(pinJoints(shown(), [leftFoot]));
    store.dispatch(setValue(actor().id, shown().poseToEdit.q, 1, -0.1, 'Lower'));
    const before = shown().pose.q.slice();
    store.dispatch(unpinJoints(actor(), [leftFoot]));
    expect(sameBits(shown().pose.q, before)).toBe(true);
  });
});

describe('a pin that follows another character', () => {
  const point = [0, 0, 0] as const;

  function shaking() {
    const walk = open(2);
    const { store, shown, actor } = walk;
    const followed = { actor: actor(0).id, joint: leftHand, point, rotation: unmoved.rotation };
    store.dispatch(pinJoints(shown(1), [leftFoot, rightFoot]));
    store.dispatch(setTransform(actor(1).id, { ...unmoved, position: [0.3, 0, 0.3] }, 'Place'));
    store.dispatch(followJoint(shown(1), rightHand, point, followed, 'Follow'));
    return walk;
  }

  const gap = ({ placeOf }: ReturnType<typeof open>): number =>
    vec3.distance(placeOf(0, leftHand), placeOf(1, rightHand));

  it('goes where that joint goes: posed, moved, turned and scaled', () => {
    const walk = shaking();
    const { store, actor, shown } = walk;
    const [{ id }] = [actor(0)];
    expect(gap(walk)).toBeLessThan(pinTolerance);
    const turned = [0, Math.sin(0.1), 0, Math.cos(0.1)] as const;
    for (const transform of [
      { ...unmoved, position: [0.05, 0.02, -0.05] as const },
      { ...unmoved, rotation: turned },
      { ...unmoved, scale: 1.1 },
    ]) {
      store.dispatch(setTransform(id, transform, 'Place'));
      expect(gap(walk)).toBeLessThan(pinTolerance);
    }
    const elbow = skeleton.dofQ[skeleton.dofStart[skeleton.parents[leftHand]!]!]!;
    store.dispatch(setValue(id, shown(0).poseToEdit.q, elbow, 0.2, 'Bend'));
    expect(gap(walk)).toBeLessThan(pinTolerance);
    expect(sameBits(shown(1).pose.q, actor(1).q)).toBe(true);
    for (let i = 0; i < 6; i++) store.undo();
    expect(actor(1).pins).toHaveLength(2);
  });

  it('moves with the other character in one step of undo', () => {
    const { store, actor } = shaking();
    const before = store.scene.value;
    store.dispatch(setTransform(actor(0).id, { ...unmoved, position: [0.1, 0, 0] }, 'Place'));
    expect(store.scene.value).not.toBe(before);
    store.undo();
    expect(store.scene.value).toBe(before);
  });

  it('is refused if it would close a circle, with the reason', () => {
    const { store, actor } = shaking();
    const { scene } = store;
    expect(whyNoFollowing(scene.value, actor(1).id, actor(0).id)).toBeNull();
    expect(whyNoFollowing(scene.value, actor(0).id, actor(1).id)).toMatch(/follows .* already/);
    expect(whyNoFollowing(scene.value, actor(0).id, actor(0).id)).toMatch(/another/);
  });

  it('becomes a plain one in a scene with a circle', () => {
    const { actor } = shaking();
    const back = { ...actor(0), pins: actor(1).pins.map((pin) => follow(pin, actor(1).id)) };
    const [first, second] = withoutCircles([back, actor(1)]);
    expect(first!.pins.some(({ follows }) => follows)).toBe(true);
    expect(second!.pins.map(({ follows }) => follows)).toEqual([null, null, null]);
  });

  it('stays where it is when the other character is removed, and follows it again after undo', () => {
    const { store, actor, placeOf, shown } = shaking();
    const before = placeOf(1, rightHand);
    const pose = shown(1).pose.q.slice();
    const pins = actor(1).pins;
    store.dispatch(removeActor(actor(0)));
    expect(actor(0).pins.map(({ follows }) => follows)).toEqual([null, null, null]);
    expect(sameBits(shown(0).pose.q, pose)).toBe(true);
    expect(vec3.distance(placeOf(0, rightHand), before)).toBe(0);
    store.undo();
    expect(actor(1).pins).toBe(pins);
  });

  it('stays as it was in an evaluation that is still', () => {
    const { store, actor, shown } = shaking();
    const still = shown(1).still();
    const before = shown(1).pose.q.slice();
    store.dispatch(setTransform(actor(0).id, { ...unmoved, position: [0.1, 0, 0] }, 'Place'));
    expect(sameBits(still.pose.q, before)).toBe(true);
    still.dispose();
  });
});

/** The pose that the pins of an actor make of values. */
function solved(actor: Actor, q: Float64Array): Float64Array {
  const values = q.slice();
  applyPins(...layerInput({ ...actor, clip: null }, values));
  return values;
}

function follow(pin: Pin, actor: number): Pin {
  return {
    ...pin,
    follows: { actor, joint: leftHand, point: [0, 0, 0], rotation: unmoved.rotation },
  };
}
