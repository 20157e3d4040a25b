import { describe, expect, it } from 'vitest';
import { jointMatrices } from '../../../src/core/forward-kinematics.ts';
import type { Skeleton } from '../../../src/core/skeleton.ts';
import { dls } from '../../../src/posing/ik/dls.ts';
import { goalChains } from '../../../src/posing/ik/goal-chains.ts';
import type { Vector3 } from '../../../src/posing/ik/problem.ts';
import { readBundled } from '../../support/bundled.ts';
import { randomBetween, randomSource, randomUnitVector } from '../../support/random.ts';
import { goalAt, goalsAt, type IkRig, problemOf, reachableGoals, sixBalls } from './ik-rigs.ts';

const degrees = 180 / Math.PI;
/** What a drag allows a joint in one frame. */
const mostTurn = 4 / degrees;

/** The right arm of the bundled human, whose joints have three hinges without limits. */
async function humanArm(): Promise<IkRig> {
  const { skeleton } = await readBundled('human');
  const names = ['Right shoulder', 'Right upper arm', 'Right forearm'];
  const joints = names.map((name) => skeleton.names.indexOf(name));
  const values = joints.flatMap((joint) => {
    const first = skeleton.dofQ[skeleton.dofStart[joint]!]!;
    return [first, first + 1, first + 2];
  });
  return {
    ...{ skeleton, joints, start: skeleton.qRest },
    goals: [goalAt(skeleton.names.indexOf('Right hand'), [0, 0, 0])],
    rangeOf: (value) => (values.includes(value) ? [-0.8, 0.8] : [0, 0]),
  };
}

/** The largest angle between the same joint's rotations in its parent's frame, in degrees. */
function largestTurn(skeleton: Skeleton, a: Float64Array, b: Float64Array): number {
  const [from, to] = [localRotations(skeleton, a), localRotations(skeleton, b)];
  return Math.max(
    ...from.map((rotation, joint) => {
      // |A − B|² = 8 sin²(angle / 2) for rotation matrices.
      const apart = Math.hypot(...rotation.map((value, i) => value - to[joint]![i]!));
      return 2 * Math.asin(Math.min(1, apart / Math.sqrt(8))) * degrees;
    }),
  );
}

/** Of each joint, the nine elements of its rotation in its parent's frame. */
function localRotations(skeleton: Skeleton, q: Float64Array): number[][] {
  const matrices = jointMatrices(skeleton, q);
  const columns = (joint: number): number[][] =>
    [0, 4, 8].map((at) => [...matrices.subarray(joint * 16 + at, joint * 16 + at + 3)]);
  return Array.from(skeleton.parents, (parent, joint) => {
    const own = columns(joint);
    if (parent < 0) return own.flat();
    const above = columns(parent);
    return own.flatMap((column) => above.map((axis) => dot(axis, column)));
  });
}

function dot(a: readonly number[], b: readonly number[]): number {
  return a.reduce((sum, value, i) => sum + value * b[i]!, 0);
}

/** Unit vectors at right angles, in a random plane. */
function randomPlane(random: () => number): [number[], number[]] {
  const u = randomUnitVector(random);
  const other = randomUnitVector(random);
  const v = other.map((value, i) => value - dot(u, other) * u[i]!);
  return [u, v.map((value) => value / Math.hypot(...v))];
}

describe.each([
  ['the arm of the human', humanArm],
  ['a chain of six balls', () => Promise.resolve(sixBalls())],
] as const)('%s', (_, rigOf) => {
  it('follows a target step by step without a jump', async () => {
    const rig = await rigOf();
    const random = randomSource(9);
    for (let path = 0; path < 4; path++) {
      const [start] = goalsAt(rig, rig.start);
      const [end] = reachableGoals(rig, random);
      const { length } = goalChains(problemOf(rig, [start!]))[0]!;
      const way = end!.target.map((value, axis) => value - start!.target[axis]!);
      const count = Math.ceil(Math.hypot(...way) / (0.01 * length));
      let from = rig.start;
      for (let step = 1; step <= count; step++) {
        const target = start!.target.map((value, axis) => value + (way[axis]! * step) / count);
        const goal = { ...start!, target: target as unknown as Vector3 };
        const options = { from, restarts: 0, mostTurn };
        const { q, residuals } = dls.solve(problemOf(rig, [goal]), options);
        expect(largestTurn(rig.skeleton, from, q)).toBeLessThan(5);
        // It does not lag behind by a step either.
        expect(residuals[0]! / length).toBeLessThan(0.01);
        from = q;
      }
    }
  });

  it('points at a target that circles beyond the reach, and does not shake', async () => {
    const rig = await rigOf();
    const [goal] = goalsAt(rig, rig.start);
    const { root, reach } = goalChains(problemOf(rig, [goal!]))[0]!;
    const random = randomSource(4);
    for (let circle = 0; circle < 2; circle++) {
      const [u, v] = randomPlane(random);
      const phase = randomBetween(random, 0, 2 * Math.PI);
      let from = rig.start;
      for (let step = 0; step <= 200; step++) {
        const angle = phase + (2 * step) / degrees;
        const target = root.map((value, axis) => {
          return value + 1.5 * reach * (Math.cos(angle) * u[axis]! + Math.sin(angle) * v[axis]!);
        });
        const problem = problemOf(rig, [{ ...goal!, target: target as unknown as Vector3 }]);
        // The press; from then on frames follow each other.
        const bound = step === 0 ? {} : { mostTurn, iterations: 10 };
        const { q, status } = dls.solve(problem, { from, restarts: 0, ...bound });
        if (step > 0) expect(largestTurn(rig.skeleton, from, q)).toBeLessThan(5);
        expect(status).toBe('out-of-reach');
        from = q;
      }
    }
  });

  it('comes to rest where the target rests beyond the reach', async () => {
    const rig = await rigOf();
    const [goal] = goalsAt(rig, rig.start);
    const { root, reach } = goalChains(problemOf(rig, [goal!]))[0]!;
    const direction = randomUnitVector(randomSource(6));
    const target = root.map((value, axis) => value + 1.5 * reach * direction[axis]!);
    const problem = problemOf(rig, [{ ...goal!, target: target as unknown as Vector3 }]);
    let from = rig.start;
    for (let frame = 0; frame < 240; frame++)
      from = dls.solve(problem, { from, restarts: 0, mostTurn, iterations: 10 }).q;
    const { q } = dls.solve(problem, { from, restarts: 0, mostTurn, iterations: 10 });
    expect(largestTurn(rig.skeleton, from, q)).toBeLessThan(1e-3);
  });
});
