import { goalChains } from '../../../src/posing/ik/goal-chains.ts';
import { ikMethod } from '../../../src/posing/ik/methods.ts';
import type { IkMethodId } from '../../../src/posing/ik/problem.ts';
import { reachedFraction } from '../../../src/posing/ik/status.ts';
import { randomSource } from '../../support/random.ts';
import { type IkRig, problemOf, reachableGoals } from './ik-rigs.ts';

/** How a method does for some reachable targets. */
export interface MethodFigures {
  /** How many targets it reached: all residuals are at most 1e-3 of their chains. */
  readonly solved: number;
  readonly medianIterations: number;
  /** The largest residual of all, in lengths of its chain. */
  readonly worst: number;
  /** Of one solve. */
  readonly medianMilliseconds: number;
  /** How many values were outside their limits. */
  readonly beyondLimits: number;
}

/** Solves from the rig's start for so many random targets, the same ones for every method. */
export async function measureMethod(
  id: IkMethodId,
  rig: IkRig,
  count: number,
): Promise<MethodFigures> {
  const solver = await ikMethod(id).load();
  const random = randomSource(5);
  const { qMin, qMax } = rig.skeleton;
  const [iterations, times, worsts]: [number[], number[], number[]] = [[], [], []];
  let beyondLimits = 0;
  for (let i = 0; i < count; i++) {
    const problem = problemOf(rig, reachableGoals(rig, random));
    const lengths = goalChains(problem).map(({ length }) => length);
    const began = performance.now();
    const found = solver.solve(problem);
    times.push(performance.now() - began);
    iterations.push(found.iterations);
    worsts.push(Math.max(...found.residuals.map((residual, goal) => residual / lengths[goal]!)));
    found.q.forEach((value, at) => {
      if (!(value >= qMin[at]! && value <= qMax[at]!)) beyondLimits++;
    });
  }
  return {
    solved: worsts.filter((worst) => worst <= reachedFraction).length,
    medianIterations: median(iterations),
    worst: Math.max(...worsts),
    medianMilliseconds: median(times),
    beyondLimits,
  };
}

function median(values: readonly number[]): number {
  return [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)]!;
}
