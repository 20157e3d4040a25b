import { mat3, quat, type ReadonlyVec3 } from 'gl-matrix';
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
  return turnEach(skeleton, q, joints, near, () => turn);
}

/**
 * Returns the pose in which some joints have changed as another one did, each in its own frame: if
 * that one's rotation went from A to B, each of them is multiplied by A⁻¹ · B, a turn by the same
 * angle. Limits hold.
 *
 * @param q (qCount) the pose before, which has all values of the joints
 * @param model the joint that has changed
 * @param after (qCount) the pose in which only that joint has changed
 */
export function turnAlike(
  skeleton: Skeleton,
  q: Float64Array,
  joints: readonly number[],
  model: number,
  after: Float64Array,
  near: Float64Array,
): Float64Array {
  const change = quat.invert(new Float64Array(4), rotationOf(skeleton, model, q));
  quat.multiply(change, change, rotationOf(skeleton, model, after));
  const others = joints.filter((joint) => joint !== model);
  const next = turnEach(skeleton, q, others, near, (own) => {
    // F · change · F⁻¹: the same turn, in the character's space.
    const turned = quat.multiply(new Float64Array(4), own, change);
    return quat.multiply(turned, turned, quat.invert(new Float64Array(4), own));
  });
  next.set(valuesOf(skeleton, model, after), jointRange(skeleton, model)[0]);
  return next;
}

/** @param turnOf the turn of a joint, for its rotation in the character's space */
function turnEach(
  skeleton: Skeleton,
  q: Float64Array,
  joints: readonly number[],
  near: Float64Array,
  turnOf: (rotation: quat) => quat,
): Float64Array {
  const next = q.slice();
  for (const joint of joints) {
    const start = turnStart(skeleton, joint, q);
    const own = quatOf(start.frames.characterFromJoint);
    const turned = turnJoint(start, turnOf(own), near);
    next.set(valuesOf(skeleton, joint, turned), jointRange(skeleton, joint)[0]);
  }
  return next;
}

function valuesOf(skeleton: Skeleton, joint: number, q: Float64Array): Float64Array {
  return q.subarray(...jointRange(skeleton, joint));
}

/** The rotation of a joint in the character's space. */
function rotationOf(skeleton: Skeleton, joint: number, q: Float64Array): quat {
  return quatOf(turnStart(skeleton, joint, q).frames.characterFromJoint);
}

function quatOf(matrix: ArrayLike<number>): quat {
  const rotation = mat3.fromMat4(new Float64Array(9), matrix as Float64Array);
  return quat.normalize(new Float64Array(4), quat.fromMat3(new Float64Array(4), rotation));
}
