import { quat } from 'gl-matrix';
import { DofKind, type Skeleton } from '../core/skeleton.ts';

export type Triple = [x: number, y: number, z: number];
export type Quaternion = [x: number, y: number, z: number, w: number];

/** What stands for a joint's rotation: three angles, or a quaternion. */
export type BallJson = Triple | Quaternion;

/** Where in q a joint's ball has its four values; -1 where the joint has none. */
export function ballValue(skeleton: Skeleton, joint: number): number {
  for (let dof = skeleton.dofStart[joint]!; dof < skeleton.dofStart[joint + 1]!; dof++) {
    if (skeleton.dofKind[dof] === DofKind.ball) return skeleton.dofQ[dof]!;
  }
  return -1;
}

/** Within this of 1 a length is that of a unit quaternion, which stays as it is, bit by bit. */
const unitTolerance = 1e-12;

/** A unit quaternion: the one given made unit, or that of angles, Rx · Ry · Rz. No numbers where it is 0. */
export function quaternionOf(value: BallJson): Quaternion {
  if (value.length === 4) {
    const length = Math.hypot(...value);
    const scale = Math.abs(length - 1) <= unitTolerance ? 1 : 1 / length;
    return value.map((each) => each * scale) as Quaternion;
  }
  const product: Quaternion = [0, 0, 0, 1];
  quat.rotateX(product, product, value[0]);
  quat.rotateY(product, product, value[1]);
  quat.rotateZ(product, product, value[2]);
  return product;
}
