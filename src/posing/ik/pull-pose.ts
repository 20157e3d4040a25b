import { DofKind, type Skeleton } from '../../core/skeleton.ts';
import { slerp } from '../joint-rotation.ts';
import type { Quaternion } from './problem.ts';

/**
 * Returns a pose that is moved by a part of the way to another one in the space of the degrees of
 * freedom: slides and hinges go straight, and balls turn the shorter way. This is the way in which
 * solvers measure the distance from their reference, so that a pull of any strength comes to rest at
 * the same pose.
 *
 * @param pose (qCount)
 * @param to (qCount)
 */
export function pullPose(
  { dofKind, dofQ }: Skeleton,
  pose: Float64Array,
  to: Float64Array,
  part: number,
): Float64Array {
  const q = pose.slice();
  for (let dof = 0; dof < dofKind.length; dof++) {
    const at = dofQ[dof]!;
    if (dofKind[dof] === DofKind.ball) q.set(slerp(ballAt(pose, at), ballAt(to, at), part), at);
    else if (q[at] !== to[at]) q[at] = q[at]! + part * (to[at]! - q[at]!);
  }
  return q;
}

function ballAt(q: Float64Array, at: number): Quaternion {
  return [q[at]!, q[at + 1]!, q[at + 2]!, q[at + 3]!];
}
