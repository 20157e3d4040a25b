import { jointMatrices } from '../../core/forward-kinematics.ts';
import type { Skeleton } from '../../core/skeleton.ts';
import { canTurn } from '../joint-frames.ts';
import { naturalLength, pathTo } from './chain.ts';
import { goalChains } from './goal-chains.ts';
import type { IkGoal, IkProblem, Vector3 } from './problem.ts';

/** A row of joints whose last one, the effector, is brought to a target by those above it. */
export interface LabChain {
  readonly skeleton: Skeleton;
  /** From the first joint that turns to the effector, each the parent of the next. */
  readonly path: readonly number[];
  /** The joints of the path above the effector that can turn. */
  readonly moving: readonly number[];
  /** The length of the chain, in model units. */
  readonly length: number;
}

/** The joint from which a chain starts by nature, or null for a root, above which nothing turns. */
export function chainStart(skeleton: Skeleton, effector: number): number | null {
  const path = pathTo(skeleton, effector);
  // A joint right below a branch needs at least its parent to be moved.
  return path.length < 2 ? null : path.at(-Math.max(2, naturalLength(skeleton, effector)))!;
}

export function labChain(skeleton: Skeleton, start: number, effector: number): LabChain {
  const whole = pathTo(skeleton, effector);
  const path = whole.slice(whole.indexOf(start));
  const moving = path.slice(0, -1).filter((joint) => canTurn(skeleton, joint));
  const chain = { skeleton, path, moving, length: 0 };
  const [found] = goalChains(problemOf(chain, skeleton.qRest, [0, 0, 0]));
  return { ...chain, length: found!.length };
}

/** The problem of bringing the chain's effector to a target from a pose. */
export function problemOf(
  { skeleton, moving, path }: LabChain,
  q: Float64Array,
  target: Vector3,
  natures: IkProblem['natures'] = [],
): IkProblem {
  const goal: IkGoal = { joint: path.at(-1)!, point: [0, 0, 0], target, weight: 1 };
  return { skeleton, goals: [goal], joints: moving, reference: q, natures };
}

/** The places of the path's joints in the character's space. */
export function pathPlaces({ skeleton, path }: LabChain, q: Float64Array): Vector3[] {
  const characterFromJoint = jointMatrices(skeleton, q);
  return path.map((joint) => {
    const [x, y, z] = characterFromJoint.subarray(joint * 16 + 12, joint * 16 + 15);
    return [x!, y!, z!];
  });
}
