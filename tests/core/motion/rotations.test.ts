import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type {
  Extrapolation,
  Quaternion,
  RotationChannelParts,
} from '../../../src/core/motion/clip-parts.ts';
import { clipFor, evaluateClip } from '../../../src/core/motion/clip.ts';
import { convertRotation } from '../../../src/core/motion/convert-rotation.ts';
import { jointRotation } from '../../../src/core/motion/joint-rotation.ts';
import { turnAngle } from '../../../src/core/motion/quaternions.ts';
import { evaluateRotation, rotationChannelFor } from '../../../src/core/motion/rotation-channel.ts';
import { rotationTrack } from '../../../src/core/motion/rotation-track.ts';
import { ball, hinge, skeletonOf } from '../../posing/ik/ik-rigs.ts';
import { clipOf, rotationChannels } from '../../support/random-channels.ts';

/** Radians; both sides are in float64. */
const tolerance = 1e-9;

const aboutX = (angle: number): Quaternion => [Math.sin(angle / 2), 0, 0, Math.cos(angle / 2)];

function spin(rule: Extrapolation, curve: 'slerp' | 'squad' = 'slerp'): RotationChannelParts {
  return {
    ...{ target: { of: 'rotation', joint: 0, curve }, before: rule, after: rule },
    keys: [0, 1, 2].map((time) => ({ time: time + 1, value: aboutX(2 * time) })),
  };
}

function rotationAt(parts: RotationChannelParts, time: number): Float64Array {
  const rotation = new Float64Array(4);
  evaluateRotation(rotationChannelFor(parts), time, rotation);
  return rotation;
}

describe('a curve of rotations outside its keys', () => {
  // The keys are at 1, 2 and 3 s, and turn 0, 2 and 4 radians about x.
  it.each<[Extrapolation, readonly number[]]>([
    ['constant', [0, 0, 4, 4]],
    ['linear', [-3, -1, 5, 9]],
    ['cycle', [1, 3, 1, 1]],
    ['cycle_offset', [-3, -1, 5, 9]],
    ['bounce', [3, 1, 3, 1]],
  ])('goes on by the rule %s', (rule, angles) => {
    [-0.5, 0.5, 3.5, 5.5].forEach((time, i) => {
      for (const curve of ['slerp', 'squad'] as const) {
        const found = rotationAt(spin(rule, curve), time);
        // A squad through equal turns is a slerp only at a constant speed, as here.
        expect(turnAngle(found, Float64Array.from(aboutX(angles[i]!)))).toBeLessThan(tolerance);
      }
    });
  });

  it('is the identity without keys, and constant with one', () => {
    expect([...rotationAt({ ...spin('cycle'), keys: [] }, 3)]).toEqual([0, 0, 0, 1]);
    const one = { ...spin('linear'), keys: [{ time: 1, value: aboutX(2) }] };
    expect([...rotationAt(one, 9)]).toEqual([...aboutX(2)]);
  });
});

const orders = ['xyz', 'zyx', 'yzx', 'zxy', 'xzy', 'yxz'] as const;

function rig(order: string, limits?: readonly [number, number]) {
  const dofs = Array.from(order, (axis) => hinge(axis as 'x' | 'y' | 'z', limits));
  return { skeleton: skeletonOf([[-1, [0, 0, 0], dofs]]), morphs: [] };
}

describe.each(orders)('three hinges in the order %s', (order) => {
  const thing = rig(order);
  const { skeleton } = thing;
  const anglesAt = (parts: RotationChannelParts, time: number) => {
    const q = skeleton.qRest.slice();
    const values = { q, morphWeights: new Float64Array(0), pins: new Float64Array(0) };
    evaluateClip(clipFor(clipOf(parts), thing), time, values);
    return q;
  };

  it('take the rotation of the curve at all times', () => {
    fc.assert(
      fc.property(
        rotationChannels('squad'),
        fc.double({ min: -9, max: 9, noNaN: true }),
        (parts, time) => {
          const found = new Float64Array(4);
          jointRotation(skeleton, 0, anglesAt(parts, time), found);
          // At a pole one angle is left out below 1e-6.
          expect(turnAngle(found, rotationAt(parts, time))).toBeLessThan(1e-5);
        },
      ),
      { numRuns: 40, endOnFailure: true },
    );
  });

  it('go on through full turns without a jump', () => {
    const parts = { ...spin('constant'), keys: [] as RotationChannelParts['keys'][number][] };
    for (let i = 0; i <= 8; i++) parts.keys.push({ time: i, value: aboutX(1.5 * i) });
    const x = order.indexOf('x');
    for (const time of [0, 3.3, 5.1, 8]) {
      expect(anglesAt(parts, time)[x]).toBeCloseTo(1.5 * time, 9);
    }
  });
});

describe('hinges with limits', () => {
  it('take equivalent angles that are within, and else their limits', () => {
    const { skeleton } = rig('xyz', [-2, 2]);
    const track = rotationTrack(spin('constant'), skeleton)!;
    expect(track.indices).toHaveLength(3);
    const thing = rig('xyz', [-2.5, 2.5]);
    const q = thing.skeleton.qRest.slice();
    const values = { q, morphWeights: new Float64Array(0), pins: new Float64Array(0) };
    const clip = clipFor(clipOf(spin('constant')), thing);
    evaluateClip(clip, 3, values);
    expect(q[0]).toBeCloseTo(4 - 2 * Math.PI, 9);
    evaluateClip(clip, 2.35, values);
    expect(q[0]).toBeCloseTo(2.5, 9);
  });
});

it('a joint with other degrees of freedom takes no rotation', () => {
  const dofs = [[], [hinge('x')], [hinge('x'), hinge('y'), hinge('x')]];
  for (const own of dofs) {
    expect(rotationTrack(spin('cycle'), skeletonOf([[-1, [0, 0, 0], own]]))).toBeNull();
  }
  const far = { ...spin('cycle'), target: { of: 'rotation', joint: 7, curve: 'slerp' } } as const;
  expect(rotationTrack(far, skeletonOf([[-1, [0, 0, 0], [ball]]]))).toBeNull();
});

describe('a rotation that is stored in another form', () => {
  const thing = rig('zyx');
  const { qRest } = thing.skeleton;

  it('keeps the rotations of its keys, and says the largest difference', () => {
    fc.assert(
      fc.property(rotationChannels('squad', { fewest: 3 }), (squad) => {
        const clip = clipOf(squad);
        const euler = convertRotation(clip, thing, 0, 'euler', qRest)!;
        expect(euler.clip.channels.map(({ target }) => target)).toEqual(
          [2, 1, 0].map((axis) => ({ of: 'value', joint: 0, kind: 1, axis })),
        );
        const back = convertRotation(euler.clip, thing, 0, 'squad', qRest)!;
        const found = back.clip.channels[0] as RotationChannelParts;
        expect(found.keys).toHaveLength(squad.keys.length);
        found.keys.forEach(({ time, value }, at) => {
          expect(time).toBe(squad.keys[at]!.time);
          const wanted = Float64Array.from(squad.keys[at]!.value);
          expect(turnAngle(Float64Array.from(value), wanted)).toBeLessThan(1e-5);
        });
        expect(euler.difference).toBeGreaterThanOrEqual(0);
        const same = convertRotation(clip, thing, 0, 'squad', qRest)!;
        expect([same.clip === clip, same.difference]).toEqual([true, 0]);
      }),
      { numRuns: 20, endOnFailure: true },
    );
  });

  it('differs where the curves are farthest apart', () => {
    const squad = { ...spin('constant', 'squad'), keys: [...spin('constant').keys] };
    squad.keys.push({ time: 4, value: [0, Math.SQRT1_2, 0, Math.SQRT1_2] });
    const slerp = convertRotation(clipOf(squad), thing, 0, 'slerp', qRest)!;
    const changed = slerp.clip.channels[0] as RotationChannelParts;
    let largest = 0;
    for (let time = 1; time <= 4; time += 0.001) {
      largest = Math.max(largest, turnAngle(rotationAt(squad, time), rotationAt(changed, time)));
    }
    expect(Math.abs(slerp.difference - largest)).toBeLessThan(2e-3);
    const here = turnAngle(rotationAt(squad, slerp.time), rotationAt(changed, slerp.time));
    expect(here).toBeCloseTo(slerp.difference, 6);
  });

  it('is not angles of a ball, nor anything of a joint that does not turn', () => {
    const balls = { skeleton: skeletonOf([[-1, [0, 0, 0], [ball]]]), morphs: [] };
    const { qRest: q } = balls.skeleton;
    const clip = clipOf(spin('constant'));
    expect(convertRotation(clip, balls, 0, 'euler', q)).toBeNull();
    expect(convertRotation(clip, balls, 0, 'squad', q)!.clip.channels[0]).toMatchObject({
      target: { curve: 'squad' },
    });
    const still = { skeleton: skeletonOf([[-1, [0, 0, 0], []]]), morphs: [] };
    expect(convertRotation(clip, still, 0, 'slerp', still.skeleton.qRest)).toBeNull();
  });
});
