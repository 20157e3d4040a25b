import { describe, expect, it } from 'vitest';
import { jointMatrices } from '../../src/core/forward-kinematics.ts';
import { plainNatures } from '../../src/posing/natural/nature-settings.ts';
import type { Vector3 } from '../../src/posing/ik/problem.ts';
import type { Pin } from '../../src/posing/pins/pin.ts';
import { holdPins } from '../../src/posing/pins/pin-layer.ts';
import { pinnedPoint } from '../../src/posing/pins/pin-target.ts';
import { readBundled } from '../support/bundled.ts';

const human = await readBundled('human');
const { skeleton } = human;
const atRest = jointMatrices(skeleton, skeleton.qRest);

/** A pin of a joint at its place at rest, or at another one. */
function pinAt(name: string, place?: Vector3): Pin {
  const held = { joint: skeleton.names.indexOf(name), point: [0, 0, 0] as const };
  const here = place ?? pinnedPoint(held, atRest);
  return { ...held, place: here, rotation: null, weight: 1, follows: null };
}

const feet = [pinAt('Left foot'), pinAt('Right foot')];

const hold = (pins: readonly Pin[], q: Float64Array): number =>
  holdPins({ character: human, pins, natures: plainNatures, followed: null }, q);

/** The root on a closed curve, as a drag of the pelvis takes it: its first five values move. */
function dragged(part: number, width: number): Float64Array {
  const q = skeleton.qRest.slice();
  const [sine, cosine] = [Math.sin(2 * Math.PI * part), Math.cos(2 * Math.PI * part)];
  const moves = [width * sine, 0.5 * width * (cosine - 1), width * sine * cosine, 0, 0.3 * sine];
  for (const [i, move] of moves.entries()) q[i] = q[i]! + move;
  return q;
}

/** The farthest that a joint is turned from one pose to the other, in degrees. */
function mostTurn(a: Float64Array, b: Float64Array): number {
  const [before, after] = [jointMatrices(skeleton, a), jointMatrices(skeleton, b)];
  const turns = skeleton.names.map((_, joint) => {
    let trace = 0;
    for (const k of [0, 1, 2, 4, 5, 6, 8, 9, 10])
      trace += before[joint * 16 + k]! * after[joint * 16 + k]!;
    return Math.acos(Math.min(1, (trace - 1) / 2));
  });
  return (180 / Math.PI) * Math.max(...turns);
}

/** A part of the curve of a drag, which is less than 1 % of its width. */
const smallPart = 0.001;
/** In degrees, in a small step. */
const most = 5;
const frames = Array.from({ length: 10 }, (_, i) => i / 10);

describe.each([
  {
    name: 'both feet and a hand within the limbs',
    pins: [...feet, pinAt('Right hand')],
    width: 0.1,
    steps: 80,
    miss: 1e-3,
  },
  {
    name: 'both feet and a hand while the pelvis goes too far',
    pins: [...feet, pinAt('Right hand')],
    width: 0.5,
    steps: 180,
    miss: 1e-3,
  },
  {
    name: 'hands that are farther apart than the arms are long',
    pins: [...feet, pinAt('Right hand'), pinAt('Left hand', [1.5, 1, 0])],
    width: 0.1,
    steps: 260,
    miss: 0.4,
  },
])('pins of $name', ({ pins, width, steps, miss }) => {
  it('take few iterations in all, and at most three where a pose was solved', () => {
    for (const part of frames) {
      const q = dragged(part, width);
      expect(hold(pins, q)).toBeLessThan(steps);
      const again = q.slice();
      expect(hold(pins, again)).toBeLessThanOrEqual(3);
      expect(again).toEqual(q);
    }
  });

  it('hold, or come near, and turn no joint far in a small step', () => {
    for (const part of frames) {
      const [q, next] = [dragged(part, width), dragged(part + smallPart, width)];
      hold(pins, q);
      hold(pins, next);
      const matrices = jointMatrices(skeleton, q);
      for (const pin of pins) {
        const gap = pinnedPoint(pin, matrices).map((value, axis) => value - pin.place[axis]!);
        expect(Math.hypot(...gap)).toBeLessThan(miss);
      }
      expect(mostTurn(q, next)).toBeLessThan(most);
    }
  });
});
