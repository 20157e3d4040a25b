import { DofKind, type Skeleton } from '../../core/skeleton.ts';
import type { GoalChain } from './goal-chains.ts';
import type { IkGoal, IkStatus } from './problem.ts';

/** Residuals at or below this fraction of their chain's length count as reached. */
export const reachedFraction = 1e-3;
/** Orientations within this angle of the goal's count as reached, in radians. */
const reachedTurn = 1e-2;

/** Says how a solve ended; see `IkStatus`. */
export function statusOf(
  goals: readonly IkGoal[],
  chains: readonly GoalChain[],
  residuals: readonly number[],
  turns: readonly number[],
  atLimits: readonly number[],
): IkStatus {
  const isReached = residuals.every((residual, goal) => {
    return residual <= reachedFraction * chains[goal]!.length && turns[goal]! <= reachedTurn;
  });
  if (isReached) return 'reached';
  if (goals.some((goal, index) => !isWithinReach(goal, chains[index]!))) return 'out-of-reach';
  return atLimits.length > 0 ? 'limits' : 'stalled';
}

/** Whether a goal's target is no farther from its chain's root than the chain is long. */
export function isWithinReach({ target }: IkGoal, { root, reach }: GoalChain): boolean {
  return Math.hypot(target[0] - root[0], target[1] - root[1], target[2] - root[2]) <= reach;
}

/** The indices of the joints' values in q that are at a hard limit and not locked by it. */
export function valuesAtLimits(
  { dofStart, dofKind, dofQ, qMin, qMax }: Skeleton,
  joints: readonly number[],
  q: Float64Array,
): number[] {
  const found: number[] = [];
  for (const joint of joints) {
    for (let dof = dofStart[joint]!; dof < dofStart[joint + 1]!; dof++) {
      const at = dofQ[dof]!;
      if (dofKind[dof] === DofKind.ball || qMin[at] === qMax[at]) continue;
      if (q[at]! <= qMin[at]! || q[at]! >= qMax[at]!) found.push(at);
    }
  }
  return found;
}
