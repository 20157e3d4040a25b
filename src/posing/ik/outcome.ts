import type { GoalChain } from './goal-chains.ts';
import type { GoalKinematics } from './goal-kinematics.ts';
import type { IkProblem, IkSolution, IkStep } from './problem.ts';
import { statusOf, valuesAtLimits } from './status.ts';

/** What a method found, as a value; the kinematics is left at q. */
export function solutionAt(
  { goals, skeleton, joints }: IkProblem,
  chains: readonly GoalChain[],
  kinematics: GoalKinematics,
  q: Float64Array,
  iterations: number,
): IkSolution {
  kinematics.update(q);
  const residuals = goals.map((_, goal) => kinematics.residual(goal));
  const turns = goals.map((_, goal) => kinematics.turn(goal));
  const atLimits = valuesAtLimits(skeleton, joints, q);
  const status = statusOf(goals, chains, residuals, turns, atLimits);
  return { q: q.slice(), residuals, turns, iterations, status, atLimits };
}

/** A step of a method as a value; the kinematics is left at q. */
export function stepAt(
  { goals, skeleton, joints }: IkProblem,
  kinematics: GoalKinematics,
  q: Float64Array,
  text: string,
  singularValues: readonly number[] = [],
): IkStep {
  kinematics.update(q);
  const residuals = goals.map((_, goal) => kinematics.residual(goal));
  return {
    q: q.slice(),
    residuals,
    text,
    atLimits: valuesAtLimits(skeleton, joints, q),
    singularValues,
  };
}

/** The worst residual in lengths of its chain, where the kinematics is; 0.1 of a turn counts too. */
export function worstResidual(chains: readonly GoalChain[], kinematics: GoalKinematics): number {
  let worst = 0;
  for (let goal = 0; goal < chains.length; goal++) {
    const residual = kinematics.residual(goal) / chains[goal]!.length;
    worst = Math.max(worst, residual, 0.1 * kinematics.turn(goal));
  }
  return worst;
}

/** The root of the weighted squares of all residuals, in lengths of their chains. */
export function weightedMiss(chains: readonly GoalChain[], kinematics: GoalKinematics): number {
  let sum = 0;
  for (let goal = 0; goal < chains.length; goal++) {
    const residual = kinematics.residual(goal) / chains[goal]!.length;
    sum += (kinematics.goals[goal]!.weight * residual) ** 2;
  }
  return Math.sqrt(sum);
}
