import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { dls } from '../../../src/posing/ik/dls.ts';
import { goalChains } from '../../../src/posing/ik/goal-chains.ts';
import { ikMethods } from '../../../src/posing/ik/methods.ts';
import type { IkGoal, IkProblem, Quaternion, Vector3 } from '../../../src/posing/ik/problem.ts';
import { randomSource } from '../../support/random.ts';
import { tolerances } from '../../tolerances.ts';
import {
  ball,
  goalAt,
  goalsAt,
  hinge,
  handsAndFeet,
  leg,
  problemOf,
  reachableGoals,
  skeletonOf,
  slide,
  triple,
} from './ik-rigs.ts';
import { randomProblems } from './random-problems.ts';

/** Two links of lengths 1 and 0.6 that bend at a shoulder of some degrees of freedom. */
function arm(shoulder = triple(), elbow = [hinge('z')]) {
  return skeletonOf([
    [-1, [0, 0, 0], shoulder],
    [0, [1, 0, 0], elbow],
  ]);
}

function problemFor(skeleton: IkProblem['skeleton'], ...goals: readonly IkGoal[]): IkProblem {
  const joints = Array.from(skeleton.names.keys());
  return { skeleton, goals, joints, reference: skeleton.qRest, natures: [] };
}

const tip: Vector3 = [0.6, 0, 0];

describe('damped least squares', () => {
  it('stretches to a target out of reach, and misses it by what is left', () => {
    for (const target of [
      [3, 0, 0],
      [0, -2, 1.5],
      [-4, 1, 0],
    ] as const) {
      const { residuals, status } = dls.solve(problemFor(arm(), { ...goalAt(1, tip), target }));
      expect(residuals[0]).toBeCloseTo(Math.hypot(...target) - 1.6, 5);
      expect(status).toBe('out-of-reach');
    }
  });

  it('folds as far as it can to a target that is too close', () => {
    const problem = problemFor(arm(), { ...goalAt(1, tip), target: [0.1, 0.05, 0] });
    const { residuals, status } = dls.solve(problem);
    expect(residuals[0]).toBeCloseTo(0.4 - Math.hypot(0.1, 0.05), 5);
    expect(status).toBe('stalled');
  });

  it('stops at a limit', () => {
    const skeleton = skeletonOf([[-1, [0, 0, 0], [hinge('z', [-0.5, 0.5])]]]);
    const goal = { ...goalAt(0, [1, 0, 0]), target: [0, 1, 0] as const };
    const { q, residuals, status, atLimits } = dls.solve(problemFor(skeleton, goal));
    expect([...q]).toEqual([0.5]);
    expect(residuals[0]).toBeCloseTo(2 * Math.sin((Math.PI / 2 - 0.5) / 2), 12);
    expect({ status, atLimits }).toEqual({ status: 'limits', atLimits: [0] });
  });

  it('bends a knee that starts straight and at its limit, and only the way that it bends', () => {
    const rig = leg();
    for (const short of [0.01, 0.1, 0.3, 0.5]) {
      const goal = { ...rig.goals[0]!, target: [0, 0.1 + short, 0] as const };
      const { q, residuals } = dls.solve(problemOf(rig, [goal]), { restarts: 0 });
      expect(residuals[0]).toBeLessThan(tolerances.reached * 0.9);
      expect(q[3]).toBeGreaterThan(0.1);
    }
  });

  it('moves what slides as well as what turns', () => {
    const skeleton = skeletonOf([
      [-1, [0, 0, 0], [slide('x', [-1, 1]), slide('y', [-1, 1])]],
      [0, [0, 0, 0], [ball]],
    ]);
    const goal = { ...goalAt(1, [0, 0, 1]), target: [0.9, -0.5, 0.6] as const };
    const { residuals, status } = dls.solve(problemFor(skeleton, goal));
    expect(residuals[0]).toBeLessThan(tolerances.reached);
    expect(status).toBe('reached');
  });

  it('turns a joint to an orientation while its point stays', () => {
    const rotation: Quaternion = [0, 0, Math.sin(0.6), Math.cos(0.6)];
    const skeleton = skeletonOf([
      [-1, [0, 0, 0], [ball]],
      [0, [1, 0, 0], [ball]],
      [1, [1, 0, 0], [ball]],
    ]);
    const goal = { ...goalAt(2, [0, 0, 0]), target: [1.2, 0.8, 0] as const, rotation };
    const { residuals, turns, status } = dls.solve(problemFor(skeleton, goal));
    expect(residuals[0]).toBeLessThan(tolerances.reached);
    expect(turns[0]).toBeLessThan(1e-3);
    expect(status).toBe('reached');
  });

  it('holds what weighs more when both can not be had', () => {
    const goals = [
      { ...goalAt(1, tip), target: [5, 0, 0] as const },
      { ...goalAt(0, [1, 0, 0], 10), target: [0, 1, 0] as const },
    ];
    const { residuals } = dls.solve(problemFor(arm(), ...goals));
    expect(residuals[1]).toBeLessThan(0.01);
  });

  it('leaves each bit as it is where the goals are reached already', async () => {
    for (const rig of [leg(), await handsAndFeet()]) {
      const problem = problemOf(rig, goalsAt(rig, rig.start));
      const { q, iterations, status } = dls.solve(problem);
      expect(Array.from(q).every((value, i) => Object.is(value, rig.start[i]))).toBe(true);
      expect({ iterations, status }).toEqual({ iterations: 0, status: 'reached' });
    }
  });

  it('goes back to its reference with the target', async () => {
    const rig = await handsAndFeet();
    const home = goalsAt(rig, rig.start);
    const away = dls.solve(problemOf(rig, reachableGoals(rig, randomSource(3))));
    const { q } = dls.solve(problemOf(rig, home), { from: away.q, restarts: 0 });
    q.forEach((value, i) => expect(value).toBeCloseTo(rig.start[i]!, 3));
  });

  it('tries no other start beyond the reach, nor if it may not', () => {
    const far = problemFor(arm(), { ...goalAt(1, tip), target: [9, 1, 0] });
    const close = problemFor(arm(), { ...goalAt(1, tip), target: [0.1, 0.05, 0] });
    const iterations = (problem: IkProblem, restarts: number): number =>
      dls.solve(problem, { restarts }).iterations;
    expect(iterations(far, 11)).toBe(iterations(far, 0));
    expect(iterations(close, 11)).toBeGreaterThan(iterations(close, 0));
  });

  it('turns no joint farther from its start than it may', () => {
    const problem = problemFor(arm([ball], [ball]), { ...goalAt(1, tip), target: [-1, 0.5, 0.2] });
    const mostTurn = 0.1;
    let from = problem.reference;
    for (let frame = 0; frame < 60; frame++) {
      const { q } = dls.solve(problem, { from, restarts: 0, mostTurn });
      for (const at of [0, 4]) {
        const dot = [0, 1, 2, 3].reduce((sum, i) => sum + q[at + i]! * from[at + i]!, 0);
        expect(2 * Math.acos(Math.min(1, Math.abs(dot)))).toBeLessThan(mostTurn * 1.02);
      }
      from = q;
    }
    expect(dls.solve(problem, { from, restarts: 0 }).residuals[0]).toBeLessThan(tolerances.reached);
  });
});

describe.each(ikMethods.map((method) => [method.id, method] as const))('%s', (_, method) => {
  it('stays within the limits, moves no other joint, and always finds the same', async () => {
    const solver = await method.load();
    fc.assert(
      fc.property(randomProblems(true), ({ problem, q: from }) => {
        const { skeleton, reference } = problem;
        const joints = problem.joints.filter((joint) => joint % 3 !== 1);
        const some = { ...problem, joints };
        const options = { from, restarts: 1, iterations: 20 };
        const { q, atLimits } = solver.solve(some, options);
        expect(solver.solve(some, options).q).toEqual(q);
        skeleton.dofKind.forEach((kind, dof) => {
          const at = skeleton.dofQ[dof]!;
          const joint = skeleton.dofStart.findLastIndex((start) => start <= dof);
          for (let i = at; i < at + (kind === 2 ? 4 : 1); i++) {
            if (!joints.includes(joint)) expect(q[i]).toBe(reference[i]);
            expect(q[i]).toBeGreaterThanOrEqual(skeleton.qMin[i]!);
            expect(q[i]).toBeLessThanOrEqual(skeleton.qMax[i]!);
          }
        });
        for (const at of atLimits) expect([skeleton.qMin[at], skeleton.qMax[at]]).toContain(q[at]);
      }),
      { numRuns: 40 },
    );
  });

  it('shows the steps of the way that it goes', async () => {
    const solver = await method.load();
    const random = randomSource(8);
    const problem = problemOf(leg(), reachableGoals(leg(), random));
    const options = { restarts: 0 };
    const all = [...solver.steps(problem, options)];
    const found = solver.solve(problem, options);
    expect(all[0]!.q).toEqual(problem.reference);
    expect(all.some(({ q }) => q.every((value, i) => value === found.q[i]))).toBe(true);
    for (const { text, singularValues } of all) {
      expect(text).toMatch(/^\S.*\.$/);
      expect(singularValues).toHaveLength(method.id === 'dls' ? 3 : 0);
      expect(singularValues).toEqual([...singularValues].sort((a, b) => b - a));
    }
  });

  it('does not get worse than its start', async () => {
    const solver = await method.load();
    fc.assert(
      fc.property(randomProblems(true), ({ problem }) => {
        const goals = problem.goals.slice(0, 1).map(({ joint, point, target }) => {
          return { joint, point, target, weight: 1 };
        });
        const one = { ...problem, goals };
        const { length } = goalChains(one)[0]!;
        const before = solver.solve(one, { iterations: 0, restarts: 0 }).residuals[0]!;
        const after = solver.solve(one, { restarts: 1 }).residuals[0]!;
        expect(after).toBeLessThanOrEqual(before + 1e-3 * length);
      }),
      { numRuns: 40 },
    );
  });
});
