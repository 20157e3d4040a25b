import { jointMatrices } from '../../core/forward-kinematics.ts';
import { noParent, type Skeleton } from '../../core/skeleton.ts';
import type { IkGoal, IkProblem } from '../ik/problem.ts';

/** A smaller change is none, in radians. */
const least = 1e-9;

/** Lengths below this part of the two limbs are zero. */
const shortest = 1e-8;

/**
 * Returns by how much more than in the reference pose a hinge between two limbs has to bend so that
 * they span the distance to the goal's target (the analytic solution of two bones, by the law of
 * cosines), in radians. The limbs are those from the nearest joint above at another place, and to the
 * goal's point. Zero if no goal is below the joint.
 *
 * The pull toward the reference would hold a straight leg straight, where no derivative tells that
 * bending it brings the foot nearer; pulled toward this bend, it has nowhere to get stuck.
 */
export function bendToReach(problem: IkProblem, joint: number): number {
  const { skeleton, goals, reference } = problem;
  const below = goals.filter((each) => isBelow(skeleton, each.joint, joint));
  const [goal] = below.sort((a, b) => b.weight - a.weight);
  if (!goal) return 0;
  const matrices = jointMatrices(skeleton, reference);
  const middle = placeOf(matrices, joint);
  const end = pointOf(matrices, goal);
  const root = rootOf(skeleton, matrices, joint, middle);
  if (!root) return 0;
  const upper = distance(root, middle);
  const lower = distance(middle, end);
  if (lower < shortest * upper) return 0;
  const change =
    bendAt(upper, lower, distance(root, goal.target)) - bendAt(upper, lower, distance(root, end));
  return Math.abs(change) < least ? 0 : change;
}

/** The angle between two limbs, 0 if they are in one line, whose ends are this far apart. */
function bendAt(upper: number, lower: number, apart: number): number {
  const cosine = (apart * apart - upper * upper - lower * lower) / (2 * upper * lower);
  return Math.acos(Math.min(Math.max(cosine, -1), 1));
}

function isBelow({ parents }: Skeleton, joint: number, above: number): boolean {
  let at = joint;
  while (at > above) at = parents[at]!;
  return at === above;
}

/** The place of the nearest joint above that is not at the same place. */
function rootOf(
  { parents }: Skeleton,
  matrices: Float64Array,
  joint: number,
  middle: readonly number[],
): readonly number[] | null {
  for (let at = parents[joint]!; at !== noParent; at = parents[at]!) {
    const place = placeOf(matrices, at);
    if (distance(place, middle) > shortest) return place;
  }
  return null;
}

function placeOf(matrices: Float64Array, joint: number): readonly number[] {
  return [...matrices.subarray(joint * 16 + 12, joint * 16 + 15)];
}

function pointOf(matrices: Float64Array, { joint, point: [x, y, z] }: IkGoal): readonly number[] {
  const m = matrices.subarray(joint * 16, joint * 16 + 16);
  return [0, 1, 2].map((row) => m[row]! * x + m[4 + row]! * y + m[8 + row]! * z + m[12 + row]!);
}

function distance(a: readonly number[], b: readonly number[]): number {
  return Math.hypot(a[0]! - b[0]!, a[1]! - b[1]!, a[2]! - b[2]!);
}
