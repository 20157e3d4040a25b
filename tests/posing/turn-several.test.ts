import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { jointRange } from '../../src/core/pose.ts';
import type { Skeleton } from '../../src/core/skeleton.ts';
import { jointFrames, parentMatrix } from '../../src/posing/joint-frames.ts';
import { ringTurn, seenRing } from '../../src/posing/ring-turn.ts';
import { turnSeveral } from '../../src/posing/turn-several.ts';
import { rotationAbout, transform } from '../reference/matrix.ts';
import { largestDifference } from '../support/compare.ts';
import { randomSource, randomUnitVector } from '../support/random.ts';
import { tolerances } from '../tolerances.ts';
import { dragRig, type DragRig, TestView, turningKinds, worldOf } from './drag-rigs.ts';

const seeds = fc.nat(1e6);
const angles = fc.double({ min: -3, max: 3, noNaN: true });
const kinds = fc.constantFrom(...turningKinds);

/** The columns of the oracle's rotation of the joint, as one row of nine numbers. */
function rotationOf(rig: DragRig, q: Float64Array): number[] {
  const world = worldOf(rig, q);
  return [0, 1, 2].flatMap((column) => [0, 1, 2].map((row) => world[row]![column]!));
}

/** The rotation after a turn about an axis of the character's space, by Rodrigues' formula. */
function turnedRotation(rotation: readonly number[], axis: readonly number[], angle: number) {
  const turn = rotationAbout(axis, angle);
  return [0, 3, 6].flatMap((at) => transform(turn, rotation.slice(at, at + 3), 0));
}

/** The angle by which the joint's rotation relative to its parent differs in two poses. */
function localAngle(skeleton: Skeleton, joint: number, a: Float64Array, b: Float64Array): number {
  const [first, second] = [a, b].map((q) => {
    const identity = new Float64Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
    return jointFrames(skeleton, joint, q, identity).characterFromJoint;
  });
  // From the length of the difference, which is exact for small angles as well.
  const squares = [0, 1, 2, 4, 5, 6, 8, 9, 10].map((i) => (first![i]! - second![i]!) ** 2);
  const chord = Math.sqrt(squares.reduce((sum, square) => sum + square, 0));
  return 2 * Math.asin(Math.min(1, chord / Math.sqrt(8)));
}

function wrapped(angle: number): number {
  return Math.abs(Math.atan2(Math.sin(angle), Math.cos(angle)));
}

describe('a turn about an axis of the scene', () => {
  it('is that of the oracle, for balls and for three hinges in any order', () => {
    fc.assert(
      fc.property(seeds, kinds, angles, (seed, kind, angle) => {
        const rig = dragRig(kind, seed);
        const axis = randomUnitVector(randomSource(seed + 1));
        const next = turnSeveral(rig.skeleton, rig.q, [1], axis, angle, rig.q);
        const expected = turnedRotation(rotationOf(rig, rig.q), axis, angle);
        expect(largestDifference(rotationOf(rig, next), expected)).toBeLessThan(tolerances.turn);
        const [from, to] = jointRange(rig.skeleton, 1);
        expect(next.slice(0, from)).toEqual(rig.q.slice(0, from));
        expect(to).toBe(next.length);
      }),
    );
  });

  it('ends at the limits of every hinge', () => {
    fc.assert(
      fc.property(seeds, fc.constantFrom('xyz', 'zyx', 'xy', 'z'), angles, (seed, kind, angle) => {
        const { skeleton, q } = dragRig(kind, seed, [-0.4, 0.3]);
        const axis = randomUnitVector(randomSource(seed + 2));
        const next = turnSeveral(skeleton, q, [1], axis, angle, q);
        for (let i = 0; i < q.length; i++) {
          expect(next[i]!).toBeGreaterThanOrEqual(skeleton.qMin[i]!);
          expect(next[i]!).toBeLessThanOrEqual(skeleton.qMax[i]!);
        }
      }),
    );
  });

  it('changes the rotation of each joint in its parent’s frame by the same angle', () => {
    fc.assert(
      fc.property(seeds, kinds, angles, (seed, kind, angle) => {
        const { skeleton, q } = dragRig(kind, seed);
        const axis = randomUnitVector(randomSource(seed + 3));
        const next = turnSeveral(skeleton, q, [0, 1], axis, angle, q);
        for (const joint of [0, 1]) {
          const own = localAngle(skeleton, joint, q, next);
          expect(Math.abs(own - wrapped(angle))).toBeLessThan(1e-7);
        }
      }),
    );
  });
});

it('a ring about the line of sight keeps the grabbed point on its circle, under the pointer', () => {
  fc.assert(
    fc.property(seeds, kinds, angles, angles, (seed, kind, grab, along) => {
      const rig = dragRig(kind, seed);
      const { skeleton, q } = rig;
      const pivot = transform(worldOf(rig, q), [0, 0, 0]);
      const view = new TestView(pivot, randomUnitVector(randomSource(seed + 5)));
      const toViewer = view.look.map((value) => -value) as [number, number, number];
      const size = 0.3;
      const point = (turn: number): number[] =>
        pivot.map(
          (value, i) =>
            value + size * (Math.cos(turn) * view.right[i]! + Math.sin(turn) * view.up[i]!),
        );
      const ring = {
        center: new Float64Array(pivot),
        first: new Float64Array(view.right.map((value) => value * size)),
        second: new Float64Array(view.up.map((value) => value * size)),
      };
      const seen = seenRing(ring, new Float64Array(view.eye), (at) => view.pixelsOf(at));
      const [from, to] = [view.pixelsOf(point(grab)), view.pixelsOf(point(grab + along))];
      const turn = ringTurn(seen, from, to, along);
      const next = turnSeveral(skeleton, q, [1], toViewer, turn, q);
      // A point of the joint that lies on the ring goes where the pointer went.
      const joint = jointFrames(skeleton, 1, q, parentMatrix(skeleton, 1, q)).characterFromJoint;
      const held = [0, 1, 2].map((column) =>
        [0, 1, 2].reduce(
          (sum, row) => sum + joint[column * 4 + row]! * (point(grab)[row]! - pivot[row]!),
          0,
        ),
      );
      const now = view.pixelsOf(transform(worldOf(rig, next), held));
      expect(Math.hypot(now[0] - to[0], now[1] - to[1])).toBeLessThan(1e-6);
    }),
  );
});
