import { mat4 } from 'gl-matrix';
import { describe, expect, it } from 'vitest';
import { buildSkeleton } from '../../src/core/build-skeleton.ts';
import { DiagnosticLog } from '../../src/core/diagnostics.ts';
import { DofKind } from '../../src/core/skeleton.ts';
import { BallAngles } from '../../src/document/ball-angles.ts';
import { type Quaternion, quaternionOf, type Triple } from '../../src/formats/ball-values.ts';
import { largestDifference } from '../support/compare.ts';
import { randomBetween, randomSource } from '../support/random.ts';

const slide = { kind: DofKind.slide, axis: [1, 0, 0] } as const;
const ball = { kind: DofKind.ball, axis: [0, 0, 0] } as const;
const joint = { name: 'a', parent: -1, restOffset: [0, 0, 0], dofs: [slide, ball] } as const;
const skeleton = buildSkeleton({ file: 'a', joints: [joint] }, new DiagnosticLog('a'))!;
/** The ball comes after the slide. */
const index = 1;

function poseOf(...angles: Triple): Float64Array {
  return Float64Array.of(0, ...quaternionOf(angles));
}

function rotationOf(q: Float64Array): Float64Array {
  const quaternion = [...q.subarray(index, index + 4)] as Quaternion;
  return mat4.fromQuat(new Float64Array(16), quaternion) as Float64Array;
}

function expectAngles(found: Readonly<Triple>, expected: Triple): void {
  expect(largestDifference(found, expected)).toBeLessThan(1e-7);
}

describe('the angles of a ball', () => {
  it('give its quaternion, as Rx · Ry · Rz', () => {
    const random = randomSource(5);
    const angles = new BallAngles();
    for (let i = 0; i < 200; i++) {
      const quaternion = [0, 1, 2, 3].map(() => randomBetween(random, -1, 1)) as Quaternion;
      const q = Float64Array.of(0, ...quaternionOf(quaternion));
      const again = poseOf(...([...angles.of(skeleton, q, index)] as Triple));
      expect(largestDifference(rotationOf(again), rotationOf(q))).toBeLessThan(1e-12);
    }
  });

  it('are a slider’s own: what it sets stays to the bit, whole turns and the others too', () => {
    const angles = new BallAngles();
    let q = skeleton.qRest;
    const settings = [
      [0, 4],
      [1, Math.PI / 2],
      [2, -7],
      [0, 4.1],
      [1, 3],
    ] as const;
    const shown: Triple = [0, 0, 0];
    for (const [axis, angle] of settings) {
      q = angles.withAngle(skeleton, q, index, axis, angle);
      shown[axis] = angle;
      expect(angles.of(skeleton, q, index)).toEqual(shown);
      expect(q).toEqual(poseOf(...shown));
    }
  });

  it('are those of the time before where an earlier quaternion comes back', () => {
    const angles = new BallAngles();
    const before = angles.withAngle(skeleton, skeleton.qRest, index, 0, 4);
    let q = before;
    for (let step = 0; step < 1000; step++) {
      q = angles.withAngle(skeleton, q, index, 0, 4 + step / 100);
    }
    expect(angles.of(skeleton, q, index)[0]).toBe(13.99);
    expect(angles.of(skeleton, before, index)).toEqual([4, 0, 0]);
    expect(angles.of(skeleton, skeleton.qRest, index)).toEqual([0, 0, 0]);
    expect(angles.of(skeleton, q, index)[0]).toBe(13.99);
  });

  it('of a quaternion from elsewhere are the nearest to those shown: nothing jumps', () => {
    const angles = new BallAngles();
    angles.withAngle(skeleton, skeleton.qRest, index, 1, 1.5);
    // Continues past the right angle, where a plain extraction of the triple jumps by half a turn.
    for (let y = 1.5; y < 8; y += 0.05) {
      expectAngles(angles.of(skeleton, poseOf(0.2, y, -0.3), index), [0.2, y, -0.3]);
    }
  });

  it('at the right angle keep the third, and give the rest to the first', () => {
    const angles = new BallAngles();
    angles.withAngle(skeleton, poseOf(0.1, 1.4, 0), index, 2, 0.5);
    expectAngles(angles.of(skeleton, poseOf(0.7, Math.PI / 2, 0.2), index), [
      0.4,
      Math.PI / 2,
      0.5,
    ]);
  });

  it('of the file’s pose are small again after any turns', () => {
    const angles = new BallAngles();
    const far = angles.withAngle(skeleton, skeleton.qRest, index, 0, 3.1);
    angles.withAngle(skeleton, far, index, 2, 3.1);
    expect(angles.of(skeleton, skeleton.qRest, index)).toEqual([0, 0, 0]);
  });

  it('are remembered for a while, not without end', () => {
    const angles = new BallAngles();
    const first = angles.withAngle(skeleton, skeleton.qRest, index, 0, 10);
    let q = first;
    for (let step = 0; step < 5000; step++) q = angles.withAngle(skeleton, q, index, 0, step / 1e4);
    // Computed again, nearest to what is shown.
    expectAngles(angles.of(skeleton, first, index), [10 - 4 * Math.PI, 0, 0]);
    expect(angles.of(skeleton, skeleton.qRest, index)).toEqual([0, 0, 0]);
  });
});
