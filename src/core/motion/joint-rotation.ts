import { DofKind, type Skeleton } from '../skeleton.ts';
import { multiply } from './quaternions.ts';

/**
 * Writes the product of a joint's own turns, its hinges and its ball from left to right, without its
 * rest rotation.
 *
 * @param q (qCount)
 * @param rotation (4) unit quaternion xyzw, written
 */
export function jointRotation(
  { dofStart, dofKind, dofQ, dofAxis }: Skeleton,
  joint: number,
  q: Float64Array,
  rotation: Float64Array,
): void {
  rotation.fill(0)[3] = 1;
  for (let dof = dofStart[joint]!; dof < dofStart[joint + 1]!; dof++) {
    const index = dofQ[dof]!;
    if (dofKind[dof] === DofKind.ball) multiply(rotation, rotation, 0, q, index);
    else if (dofKind[dof] === DofKind.hinge) {
      const sine = Math.sin(q[index]! / 2);
      for (let i = 0; i < 3; i++) turn[i] = dofAxis[dof * 3 + i]! * sine;
      turn[3] = Math.cos(q[index]! / 2);
      multiply(rotation, rotation, 0, turn, 0);
    }
  }
}

const turn = new Float64Array(4);
