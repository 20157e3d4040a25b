import { quat } from 'gl-matrix';
import type { Quaternion } from '../core/motion/clip-parts.ts';
import { DofKind, type Skeleton } from '../core/skeleton.ts';

/**
 * The rotation of a joint: the product of its own turns in stored order, without its rest rotation.
 *
 * @param q (qCount)
 * @returns unit quaternion xyzw
 */
export function jointTurn(skeleton: Skeleton, q: Float64Array, joint: number): Quaternion {
  const { dofStart, dofKind, dofQ, dofAxis } = skeleton;
  let turn: [number, number, number, number] | null = null;
  for (let dof = dofStart[joint]!; dof < dofStart[joint + 1]!; dof++) {
    if (dofKind[dof] === DofKind.slide) continue;
    const own = ownTurn(dofKind[dof]!, q.subarray(dofQ[dof]), dofAxis.subarray(dof * 3));
    // A single ball keeps its exact bits.
    if (!turn) turn = own;
    else quat.multiply(turn, turn, own);
  }
  return turn ?? [0, 0, 0, 1];
}

function ownTurn(
  kind: number,
  q: Float64Array,
  axis: Float64Array,
): [number, number, number, number] {
  if (kind === DofKind.ball) return [q[0]!, q[1]!, q[2]!, q[3]!];
  const turn: [number, number, number, number] = [0, 0, 0, 1];
  quat.setAxisAngle(turn, [axis[0]!, axis[1]!, axis[2]!], q[0]!);
  return turn;
}
