import type { ReadonlyVec3 } from 'gl-matrix';
import { jointRange } from '../core/pose.ts';
import type { Skeleton } from '../core/skeleton.ts';
import { turnAbout, turnJoint, turnStart } from './turn-joint.ts';

/**
 * Returns the pose in which each of some joints has turned by one angle about one axis, each about
 * its own pivot and with the axis as it stands for it in `q`: a joint below another one turns by the
 * angle in its parent's frame, so that along a chain the angles add up. Limits hold.
 *
 * @param axis unit vector, in the character's space
 * @param near (qCount) of equivalent values those nearest to these are taken
 */
export function turnSeveral(
  skeleton: Skeleton,
  q: Float64Array,
  joints: readonly number[],
  axis: ReadonlyVec3,
  angle: number,
  near: Float64Array,
): Float64Array {
  const turn = turnAbout(Float64Array.from(axis), angle);
  const next = q.slice();
  for (const joint of joints) {
    const [from, to] = jointRange(skeleton, joint);
    next.set(turnJoint(turnStart(skeleton, joint, q), turn, near).subarray(from, to), from);
  }
  return next;
}
