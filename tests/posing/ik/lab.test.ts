import { beforeAll, describe, expect, it } from 'vitest';
import type { Skeleton } from '../../../src/core/skeleton.ts';
import { type GoalChain, goalChains } from '../../../src/posing/ik/goal-chains.ts';
import { mostLabSteps, runLab } from '../../../src/posing/ik/lab.ts';
import {
  chainStart,
  type LabChain,
  labChain,
  problemOf,
} from '../../../src/posing/ik/lab-chain.ts';
import { manipulability } from '../../../src/posing/ik/lab-ellipsoid.ts';
import { labTask, type TargetKind } from '../../../src/posing/ik/lab-targets.ts';
import { ikMethods } from '../../../src/posing/ik/methods.ts';
import type { IkSolver, IkStep, Vector3 } from '../../../src/posing/ik/problem.ts';
import { naturesOf } from '../../../src/posing/natural/natures.ts';
import { readBundled } from '../../support/bundled.ts';
import { ball, hinge, leg, placeOf, sixBalls, skeletonOf, slide } from './ik-rigs.ts';

const kinds: readonly TargetKind[] = ['reachable', 'far', 'close', 'straight'];
/** How far a step may move the effector away, as a part of the chain's length. */
const mostPull = 0.01;
/** Of lengths that are computed in two ways. */
const rounding = 1e-9;

/** A chain of every kind of degree of freedom, one of them about an axis of its own. */
function mixed(): Skeleton {
  const own = { ...hinge('x', [-1, 2]), axis: [0.6, 0, 0.8] as const };
  return skeletonOf([
    [-1, [0, 0, 0], [hinge('y'), hinge('x')]],
    [0, [0, 1, 0.1], [ball]],
    [1, [0.2, 0.8, 0], [own]],
    [2, [0, 0.7, 0], [slide('y', [-0.1, 0.2]), hinge('z', [0, 1.5])]],
    [3, [0, 0.5, 0], []],
  ]);
}

const chains = new Map<string, LabChain>();
const solvers = new Map<string, IkSolver>();
beforeAll(async () => {
  for (const { id, load } of ikMethods) solvers.set(id, await load());
  const { skeleton: human } = await readBundled('human');
  const hand = human.names.indexOf('Left hand');
  chains.set('arm', labChain(human, chainStart(human, hand)!, hand));
  chains.set('six balls', labChain(sixBalls().skeleton, 0, 5));
  chains.set('leg', labChain(leg().skeleton, 0, 2));
  chains.set('mixed', labChain(mixed(), 0, 4));
});

const distance = (a: Vector3, b: Vector3): number =>
  Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
const effectorAt = ({ skeleton, path }: LabChain, q: Float64Array): Vector3 =>
  placeOf(skeleton, q, path.at(-1)!, [0, 0, 0]);
const dls = (): IkSolver => solvers.get('dls')!;

describe.each(['arm', 'six balls', 'leg', 'mixed'])('the lab with the chain "%s"', (name) => {
  it.each(ikMethods.map(({ id }) => id))(
    'shows %s from the start to what it solves, within the limits',
    (id) => {
      const chain = chains.get(name)!;
      const { qMin, qMax, qRest } = chain.skeleton;
      for (const kind of kinds) {
        const { q: start, target } = labTask(kind, chain, qRest, dls());
        const problem = problemOf(chain, start, target);
        const { steps, solution } = runLab(solvers.get(id)!, problem);
        const [{ length }] = goalChains(problem) as [GoalChain];
        expect(steps[0]!.q).toEqual(start);
        expect(steps.at(-1)!.q).toEqual(solution.q);
        for (const { q, residuals, error, atLimits, text } of steps) {
          const residual = distance(effectorAt(chain, q), target);
          expect(Math.abs(residuals[0]! - residual)).toBeLessThan(rounding);
          expect(Math.abs(error * length - residual)).toBeLessThan(rounding);
          expect(q.every((value, i) => value >= qMin[i]! && value <= qMax[i]!)).toBe(true);
          for (const i of atLimits) expect([qMin[i], qMax[i]]).toContain(q[i]);
          expect(text).toMatch(/\.$/);
        }
      }
    },
  );

  it('comes nearer step by step with damped least squares, but for its pull to the start', () => {
    const chain = chains.get(name)!;
    const { q, target } = labTask('reachable', chain, chain.skeleton.qRest, dls());
    const problem = problemOf(chain, q, target);
    const { steps } = runLab(dls(), problem, { restarts: 0 });
    expect(steps.length).toBeGreaterThan(2);
    steps.slice(1).forEach(({ error }, i) => {
      expect(error).toBeLessThan(steps[i]!.error + mostPull);
    });
    expect(steps.at(-1)!.error).toBeLessThan(1e-3);
  });

  it('has targets of which each is what its kind says', () => {
    const chain = chains.get(name)!;
    const { qRest } = chain.skeleton;
    const root = placeOf(chain.skeleton, qRest, chain.path[0]!, [0, 0, 0]);
    const taskOf = (kind: TargetKind) => labTask(kind, chain, qRest, dls());
    const away = (kind: TargetKind): number => distance(root, taskOf(kind).target) / chain.length;
    expect(taskOf('reachable')).toEqual(taskOf('reachable'));
    const { target, q } = taskOf('reachable');
    expect(dls().solve(problemOf(chain, q, target)).status).toBe('reached');
    expect(distance(effectorAt(chain, q), target)).toBeGreaterThan(0.1 * chain.length);
    expect(away('far')).toBeCloseTo(1.3, 9);
    expect(away('close')).toBeLessThan(0.05);
    const straight = taskOf('straight');
    const end = effectorAt(chain, straight.q);
    expect(distance(root, end)).toBeGreaterThan(0.75 * chain.length);
    const sum = distance(root, straight.target) + distance(straight.target, end);
    expect(sum, 'on the line').toBeCloseTo(distance(root, end), 9);
  });

  it('gives the ellipsoid of what small turns reach', () => {
    const chain = chains.get(name)!;
    const { qRest } = chain.skeleton;
    const { q } = labTask('reachable', chain, qRest, dls());
    const axes = manipulability(chain, q);
    const columns = jacobianOf(chain, q);
    axes.forEach(({ direction, size }, i) => {
      expect(Math.hypot(...direction)).toBeCloseTo(1, 12);
      const moved = columns.map((column) => dot(column, direction) / chain.length);
      expect(Math.hypot(...moved)).toBeCloseTo(size, 5);
      if (i > 0) expect(size).toBeLessThanOrEqual(axes[i - 1]!.size);
      for (const other of axes.slice(i + 1)) {
        expect(dot(direction, other.direction)).toBeCloseTo(0, 12);
      }
    });
    const [first, second] = runLab(
      dls(),
      problemOf(chain, q, labTask('far', chain, q, dls()).target),
    ).steps;
    expect(first!.q).toEqual(q);
    second!.singularValues.forEach((value, i) => expect(value).toBeCloseTo(axes[i]!.size, 9));
  });
});

/** The effector's derivatives by each free value, and by turns of balls, as differences. */
function jacobianOf(chain: LabChain, q: Float64Array): number[][] {
  const { skeleton, moving } = chain;
  const small = 1e-6;
  const columns: number[][] = [];
  for (const joint of moving) {
    for (let dof = skeleton.dofStart[joint]!; dof < skeleton.dofStart[joint + 1]!; dof++) {
      const at = skeleton.dofQ[dof]!;
      const isBall = skeleton.dofKind[dof] === 2;
      if (!isBall && skeleton.qMin[at] === skeleton.qMax[at]) continue;
      for (let axis = 0; axis < (isBall ? 3 : 1); axis++) {
        const [to, from] = [small, -small].map((by) => {
          const moved = q.slice();
          if (isBall) moved.set(turnedBall(q.subarray(at, at + 4), axis, by), at);
          else moved[at]! += by;
          return effectorAt(chain, moved);
        });
        columns.push(to!.map((value, i) => (value - from![i]!) / (2 * small)));
      }
    }
  }
  return columns;
}

/** A quaternion xyzw, rotated about an axis of its own frame. */
function turnedBall([x, y, z, w]: Float64Array, axis: number, angle: number): number[] {
  const [a, b, c] = [0, 1, 2].map((i) => (i === axis ? angle / 2 : 0)) as [number, number, number];
  return [
    x! + w! * a + y! * c - z! * b,
    y! + w! * b + z! * a - x! * c,
    z! + w! * c + x! * b - y! * a,
    w! - x! * a - y! * b - z! * c,
  ];
}

function dot(a: readonly number[], b: readonly number[]): number {
  return a.reduce((sum, value, i) => sum + value * b[i]!, 0);
}

/** Counts from `first` to `last` in its only value, and takes `taken` in the end. */
function counting(last: number, taken = last): IkSolver {
  const stepAt = (value: number): IkStep => ({
    ...{ q: Float64Array.of(value), residuals: [last - value], text: `Step ${value}.` },
    ...{ atLimits: [], singularValues: [] },
  });
  return {
    solve: () => ({ ...stepAt(taken), turns: [0], iterations: last, status: 'stalled' }),
    *steps() {
      for (let value = 0; value <= last; value++) yield stepAt(value);
    },
  };
}

describe('the steps of the lab', () => {
  const chain = (): LabChain => chains.get('leg')!;
  const problem = () => problemOf(chain(), chain().skeleton.qRest, [0, 0, 0]);

  it('are all of them, up to a number, and always the last', () => {
    const few = runLab(counting(7), problem());
    expect(few.steps.map(({ q }) => q[0])).toEqual([0, 1, 2, 3, 4, 5, 6, 7]);
    expect(few.leftOut).toBe(0);
    const many = runLab(counting(500), problem());
    expect(many.steps).toHaveLength(mostLabSteps + 1);
    expect(many.steps.at(-1)!.text).toBe('Step 500.');
    expect(many.leftOut).toBe(500 - mostLabSteps);
  });

  it('end with the best pose, where a method tried others after it', () => {
    const { steps } = runLab(counting(5, 3), problem());
    expect(steps).toHaveLength(7);
    expect(steps.at(-1)!.q).toEqual(Float64Array.of(3));
  });

  it('begin with the pose and end with the solution where joints keep to their natures', async () => {
    const arm = chains.get('arm')!;
    const { qRest } = arm.skeleton;
    const { target } = labTask('close', arm, qRest, dls());
    const natures = naturesOf(await readBundled('human'));
    const { steps, solution } = runLab(dls(), problemOf(arm, qRest, target, natures));
    expect(steps[0]!.q).toEqual(qRest);
    expect(steps.at(-1)!.q).toEqual(solution.q);
    for (const { q, residuals } of steps) {
      expect(Math.abs(residuals[0]! - distance(effectorAt(arm, q), target))).toBeLessThan(rounding);
    }
  });

  it('start a chain below the next branch, or with the parent where that branches', async () => {
    const { skeleton } = await readBundled('human');
    const startOf = (name: string): string => {
      const start = chainStart(skeleton, skeleton.names.indexOf(name));
      return start === null ? 'none' : skeleton.names[start]!;
    };
    expect(startOf('Left hand')).toBe('Left shoulder');
    expect(startOf('Left foot')).toBe('Left hip');
    expect(startOf('Left shoulder')).toBe('Chest');
    expect(startOf('Root')).toBe('none');
  });
});
