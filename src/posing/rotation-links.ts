import { quat } from 'gl-matrix';
import { DofKind, type Skeleton } from '../core/skeleton.ts';
import { slerp } from './joint-rotation.ts';
import type { LayerFunction } from './pose-layer.ts';

/**
 * Lets joints copy the rotations of others: `q_joint ← q_joint · q_source^ratio`, in the order of the
 * list. A joint that was changed passes its rotation on to those that come later. Both rotations
 * are those of balls relative to the file's pose; a joint without a ball is left as it is.
 */
export const applyRotationLinks: LayerFunction = ({ character }, { q }) => {
  const { skeleton, rotationLinks } = character;
  for (const { joint, source, ratio } of rotationLinks) {
    const [to, from] = [ballOf(skeleton, joint), ballOf(skeleton, source)];
    if (to < 0 || from < 0) continue;
    const [x, y, z, w] = q.subarray(from, from + 4);
    const copied = slerp([0, 0, 0, 1], [x!, y!, z!, w!], ratio);
    const own = q.subarray(to, to + 4);
    quat.normalize(own, quat.multiply(own, own, copied));
  }
};

/** Where the four values of the joint's ball start in q, or -1 if it has none. */
function ballOf({ dofStart, dofKind, dofQ }: Skeleton, joint: number): number {
  for (let dof = dofStart[joint]!; dof < dofStart[joint + 1]!; dof++) {
    if (dofKind[dof] === DofKind.ball) return dofQ[dof]!;
  }
  return -1;
}
