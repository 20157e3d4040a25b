import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { Quaternion, RotationChannelParts } from '../../../src/core/motion/clip-parts.ts';
import { jointRotation } from '../../../src/core/motion/joint-rotation.ts';
import { turnAngle } from '../../../src/core/motion/quaternions.ts';
import { evaluateTrack, rotationTrack } from '../../../src/core/motion/rotation-track.ts';
import { hinge, skeletonOf } from '../../posing/ik/ik-rigs.ts';
import { rotationChannels } from '../../support/random-channels.ts';

const orders = ['xyz', 'zyx', 'yzx', 'zxy', 'xzy', 'yxz'] as const;
type Order = (typeof orders)[number];

/** Into how many steps a curve is divided. */
const steps = 3000;

/** Radians that an angle may jump beyond the motion: its bound holds for infinitely small steps. */
const slack = 1e-4;

/** Where the middle angle is nearer than this to a right angle, the two others may race. */
const nearPole = 0.02;

const skeletons = new Map(
  orders.map((order) => {
    const dofs = Array.from(order, (axis) => hinge(axis as 'x' | 'y' | 'z'));
    return [order, skeletonOf([[-1, [0, 0, 0], dofs]])];
  }),
);

/**
 * Follows a curve in small steps. With a turn ω, the middle angle changes by at most ω, and the
 * others by at most ω divided by its least cosine on the way. Returns by how many radians an angle
 * changed more than that, away from the poles, and how far the rotation of the angles is off.
 */
function follow(parts: RotationChannelParts, order: Order) {
  const skeleton = skeletons.get(order)!;
  const track = rotationTrack(parts, skeleton)!;
  const [start, end] = [parts.keys[0]!.time, parts.keys.at(-1)!.time];
  const q = skeleton.qRest.slice();
  const former = new Float64Array(3);
  const [rotation, earlier] = [new Float64Array(4), new Float64Array(4)];
  let [farthest, offPath] = [0, 0];
  for (let i = 0; i <= steps; i++) {
    evaluateTrack(track, Math.min(start + ((end - start) * i) / steps, end), q);
    jointRotation(skeleton, 0, q, rotation);
    offPath = Math.max(offPath, turnAngle(rotation, track.rotation));
    if (i > 0) {
      const turn = turnAngle(track.rotation, earlier);
      const cosine = Math.min(Math.abs(Math.cos(q[1]!)), Math.abs(Math.cos(former[1]!)));
      const [a, b, c] = [0, 1, 2].map((at) => Math.abs(q[at]! - former[at]!));
      if (cosine > Math.max(nearPole, 3 * turn)) {
        farthest = Math.max(farthest, b! - turn, Math.max(a!, c!) - turn / (cosine - turn));
      }
    }
    former.set(q.subarray(0, 3));
    earlier.set(track.rotation);
  }
  return { farthest, offPath };
}

describe.each(orders)('angles in the order %s along a curve of rotations', (order) => {
  it('never jump farther than the rotation turns', () => {
    fc.assert(
      fc.property(rotationChannels('squad'), (parts) => {
        const { farthest, offPath } = follow(parts, order);
        expect(farthest).toBeLessThan(slack);
        expect(offPath).toBeLessThan(1e-5);
      }),
      { numRuns: 12, endOnFailure: true },
    );
  });

  it('never do beside a pole, or through it', () => {
    const angle = fc.double({ min: -3, max: 3, noNaN: true });
    const distance = fc.constantFrom(0, 1e-9, 1e-7, 1e-6, 1e-5, 1e-3, 0.02, 0.2, -1e-6, -0.05);
    const near = fc.tuple(angle, distance, angle, fc.boolean());
    fc.assert(
      fc.property(fc.array(near, { minLength: 2, maxLength: 5 }), (chosen) => {
        const keys = chosen.map(([a, from, c, isUp], time) => {
          const value = product(order, [a, (isUp ? 1 : -1) * (Math.PI / 2 - from), c]);
          return { time, value };
        });
        const target = { of: 'rotation', joint: 0, curve: 'squad' } as const;
        const { farthest, offPath } = follow(
          { target, before: 'constant', after: 'constant', keys },
          order,
        );
        expect(farthest).toBeLessThan(slack);
        expect(offPath).toBeLessThan(1e-5);
      }),
      { numRuns: 20, endOnFailure: true },
    );
  });

  // The middle one turns back at its poles.
  it.each([0, 2])('count turns in a cycle with offset about the hinge %i', (hinge) => {
    const angles: [number, number, number] = [0, 0, 0];
    angles[hinge] = 1.75;
    const keys = [
      { time: 0, value: product(order, [0, 0, 0]) },
      { time: 1, value: product(order, angles) },
    ];
    const target = { of: 'rotation', joint: 0, curve: 'slerp' } as const;
    const parts = { target, before: 'cycle_offset', after: 'cycle_offset', keys } as const;
    const skeleton = skeletons.get(order)!;
    const q = skeleton.qRest.slice();
    for (const time of [-7.3, -1, 0.5, 1, 2.999, 3, 10.5, 40]) {
      evaluateTrack(rotationTrack(parts, skeleton)!, time, q);
      [0, 1, 2].forEach((at) => expect(q[at]).toBeCloseTo(at === hinge ? 1.75 * time : 0, 9));
    }
  });
});

function product(order: Order, angles: readonly [number, number, number]): Quaternion {
  const skeleton = skeletons.get(order)!;
  const rotation = new Float64Array(4);
  jointRotation(skeleton, 0, Float64Array.from(angles), rotation);
  const [x, y, z, w] = rotation;
  return [x!, y!, z!, w!];
}
