import { mat3, vec3 } from 'gl-matrix';
import { freeHinges, jointFrames } from './joint-frames.ts';
import type { TurnStart } from './turn-joint.ts';

const mostSteps = 80;
/** Misses smaller than this part of the grabbed point's distance are none. */
const exact = 1e-12;

/** Values of a joint, and how far from its target they leave the point. */
export interface Reached {
  readonly q: Float64Array;
  readonly miss: number;
}

/**
 * The values of the joint's free hinges, within their limits, that bring a point of it nearest to a
 * target, from `from` on: damped least squares with the hinges that are at a limit and pushed
 * outward held fast (Wampler 1986; Levenberg and Marquardt's control of the damping). What the
 * target does not ask for, a roll, changes least.
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
  const { skeleton, joint, worldFromParent } = start;
  const { qMin, qMax } = skeleton;
  let q = from;
  let state = look(q);
  const size = vec3.squaredLength(point);
  let damping = 1e-3 * size;
  for (let step = 0; step < mostSteps && state.miss * state.miss > exact * exact * size; step++) {
    const change = solve(q, state, damping);
    const next = q.slice();
    let largest = 0;
    change.forEach(([index, value]) => {
      next[index] = Math.min(Math.max(q[index]! + value, qMin[index]!), qMax[index]!);
      largest = Math.max(largest, Math.abs(next[index] - q[index]!));
    });
    if (largest < 1e-14) break;
    const there = look(next);
    if (there.miss < state.miss) {
      [q, state] = [next, there];
      damping = Math.max(damping * 0.2, 1e-15 * size);
    } else damping = damping * 5 + 1e-15 * size;
  }
  return { q, miss: state.miss };

  function look(values: Float64Array) {
    const frames = jointFrames(skeleton, joint, values, worldFromParent);
    const place = vec3.transformMat4(new Float64Array(3), point, frames.worldFromJoint);
    const rest = vec3.subtract(new Float64Array(3), target, place);
    const columns = freeHinges(skeleton, frames).map(({ axis, origin, index }) => {
      const arm = vec3.subtract(new Float64Array(3), place, origin);
      return { index, column: vec3.cross(arm, axis, arm) };
    });
    return { rest, columns, miss: vec3.length(rest) };
  }

  function solve(values: Float64Array, { rest, columns }: ReturnType<typeof look>, lambda: number) {
    const moving = columns.filter(({ index, column }) => {
      const push = vec3.dot(column, rest);
      return push > 0 ? values[index]! < qMax[index]! : values[index]! > qMin[index]!;
    });
    // Jᵀ (J Jᵀ + λ)⁻¹ r: three rows, however many hinges.
    const matrix: mat3 = new Float64Array([lambda, 0, 0, 0, lambda, 0, 0, 0, lambda]);
    for (const { column } of moving) {
      for (let i = 0; i < 9; i++)
        matrix[i] = matrix[i]! + column[i % 3]! * column[Math.floor(i / 3)]!;
    }
    if (!mat3.invert(matrix, matrix)) return [];
    const weights = vec3.transformMat3(new Float64Array(3), rest, matrix);
    return moving.map(({ index, column }) => [index, vec3.dot(column, weights)] as const);
  }
}
