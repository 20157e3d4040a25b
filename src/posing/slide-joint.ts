import { type ReadonlyVec3, vec3 } from 'gl-matrix';
import { DofKind, type Skeleton } from '../core/skeleton.ts';
import { jointFrames, parentMatrix } from './joint-frames.ts';

/**
 * Returns the pose in which a joint's slides have moved it by a vector, as far as they can: each
 * slide takes the vector's component along its axis, within its limits.
 *
 * @param q (qCount) the pose before
 * @param vector in the character's space
 */
export function slideJoint(
  skeleton: Skeleton,
  q: Float64Array,
  joint: number,
  vector: ReadonlyVec3,
): Float64Array {
  const { dofs } = jointFrames(skeleton, joint, q, parentMatrix(skeleton, joint, q));
  const moved = q.slice();
  for (const { kind, index, axis } of dofs) {
    if (kind !== DofKind.slide) continue;
    const wanted = q[index]! + vec3.dot(vector, axis);
    moved[index] = Math.min(Math.max(wanted, skeleton.qMin[index]!), skeleton.qMax[index]!);
  }
  return moved;
}
