import { quat } from 'gl-matrix';
import { DofKind, type Skeleton } from '../core/skeleton.ts';
import type { LayerFunction } from './pose-layer.ts';

/**
 * Lets joints copy the rotations of others: `q_joint ← q_joint · q_source^ratio`, in the order of the
 * list. A joint that was changed passes its rotation on to those that come later. Both rotations
 * are those of balls relative to the file's pose; a joint without a ball is left as it is.
 */
export const applyRotationLinks: LayerFunction = ({ character }, q) => {
  const { skeleton, rotationLinks } = character;
  for (const { joint, source, ratio } of rotationLinks) {
    const [to, from] = [ballOf(skeleton, joint), ballOf(skeleton, source)];
    if (to < 0 || from < 0) continue;
    for (let i = 0; i < 4; i++) {
      own[i] = q[to + i]!;
      copied[i] = q[from + i]!;
    }
    quat.slerp(copied, identity, copied, ratio);
    quat.normalize(own, quat.multiply(own, own, copied));
    for (let i = 0; i < 4; i++) q[to + i] = own[i]!;
  }
};

/** Where the four values of the joint's ball start in q, or -1 if it has none. */
function ballOf({ dofStart, dofKind, dofQ }: Skeleton, joint: number): number {
  for (let dof = dofStart[joint]!; dof < dofStart[joint + 1]!; dof++) {
    if (dofKind[dof] === DofKind.ball) return dofQ[dof]!;
  }
  return -1;
}

const identity: quat = Float64Array.of(0, 0, 0, 1);
const own: quat = new Float64Array(4);
const copied: quat = new Float64Array(4);
