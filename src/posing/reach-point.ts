import { vec3 } from 'gl-matrix';
import { freeHinges, jointFrames } from './joint-frames.ts';
import { solveLinear } from './solve-linear.ts';
import type { TurnStart } from './turn-joint.ts';

const mostSteps = 60;
const mostDamping = 1e6;
/** Errors and steps below this fraction of the whole count as zero. */
const exact = 1e-12;

/** Values of a joint, and the distance that remains between the point and its target. */
export interface Reached {
  readonly q: Float64Array;
  readonly miss: number;
}

/**
 * Returns the values of the joint's free hinges, within their limits, that bring a point of it
 * nearest to a target, in the local minimum of `from`. It uses Newton's method with Levenberg and
 * Marquardt's damping, and holds hinges at a limit. Rotations that do not affect the target, such
 * as a roll, change least.
 *
 * @param point in the joint's frame
 * @param target in the character's space
 */
export function reachPoint(
  start: TurnStart,
  point: vec3,
  target: vec3,
  from: Float64Array,
): Reached {
  const size = vec3.dot(point, point);
  let q = from;
  let now = lookAt(start, q, point, target);
  let damping = 1e-3 * size;
  for (let step = 0; step < mostSteps && now.miss ** 2 > exact ** 2 * size; step++) {
    if (damping > mostDamping * size) break;
    const next = stepWithin(start, q, now, damping);
    const there = next && lookAt(start, next, point, target);
    if (next && there && there.miss < now.miss) {
      [q, now] = [next, there];
      damping = Math.max(damping * 0.1, 1e-15 * size);
    } else damping = Math.max(damping, 1e-6 * size) * 10; // toward steepest descent
  }
  return { q, miss: now.miss };
}

/** Half the squared distance for some values, and its derivatives by the hinges. */
interface Look {
  readonly indices: readonly number[];
  readonly gradient: readonly number[];
  readonly hessian: readonly (readonly number[])[];
  readonly miss: number;
}

function lookAt(start: TurnStart, q: Float64Array, point: vec3, target: vec3): Look {
  const { skeleton, joint, worldFromParent } = start;
  const frames = jointFrames(skeleton, joint, q, worldFromParent);
  const hinges = freeHinges(skeleton, frames);
  const place = vec3.transformMat4(new Float64Array(3), point, frames.characterFromJoint);
  const rest = vec3.subtract(new Float64Array(3), place, target);
  const slopes = hinges.map(({ axis, origin }) => {
    const arm = vec3.subtract(new Float64Array(3), place, origin);
    return vec3.cross(arm, axis, arm);
  });
  const hessian = hinges.map((_, i) =>
    hinges.map((__, j) => {
      // The outer hinge rotates the derivative of the inner one.
      const [outer, inner] = i < j ? [i, j] : [j, i];
      const bend = vec3.cross(new Float64Array(3), hinges[outer]!.axis, slopes[inner]!);
      return vec3.dot(slopes[i]!, slopes[j]!) + vec3.dot(rest, bend);
    }),
  );
  return {
    indices: hinges.map(({ index }) => index),
    gradient: slopes.map((slope) => vec3.dot(slope, rest)),
    hessian,
    miss: vec3.length(rest),
  };
}

/**
 * Takes one damped step, or returns null if there is none. Hinges that would exceed a limit go to
 * it, and the others are solved again.
 */
function stepWithin(
  { skeleton: { qMin, qMax } }: TurnStart,
  q: Float64Array,
  { indices, gradient, hessian }: Look,
  damping: number,
): Float64Array | null {
  const low = indices.map((index) => qMin[index]! - q[index]!);
  const high = indices.map((index) => qMax[index]! - q[index]!);
  const steps = indices.map(() => 0);
  let moving = indices
    .map((_, i) => i)
    .filter((i) => (gradient[i]! > 0 ? low[i]! < 0 : high[i]! > 0));
  while (moving.length > 0) {
    const held = indices.map((_, i) => i).filter((i) => !moving.includes(i));
    const matrix = moving.map((i) => moving.map((j) => hessian[i]![j]! + (i === j ? damping : 0)));
    const right = moving.map(
      (i) => -gradient[i]! - held.reduce((sum, j) => sum + hessian[i]![j]! * steps[j]!, 0),
    );
    const solved = solveLinear(matrix, right);
    if (!solved) return null;
    moving.forEach((i, at) => (steps[i] = Math.min(Math.max(solved[at]!, low[i]!), high[i]!)));
    const inside = moving.filter((i, at) => steps[i] === solved[at]);
    if (inside.length === moving.length) break;
    moving = inside;
  }
  if (steps.every((step) => Math.abs(step) < exact)) return null;
  const next = q.slice();
  indices.forEach((index, i) => {
    next[index] = Math.min(Math.max(q[index]! + steps[i]!, qMin[index]!), qMax[index]!);
  });
  return next;
}
