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
    const divisor = Math.abs(length - 1) <= unitTolerance ? 1 : length;
    return value.map((each) => each / divisor) as Quaternion;
  }
  // Written out, so that the first picture does not wait for a library of quaternions.
  const [sx, sy, sz] = value.map((angle) => Math.sin(angle / 2)) as Triple;
  const [cx, cy, cz] = value.map((angle) => Math.cos(angle / 2)) as Triple;
  return [
    sx * cy * cz + cx * sy * sz,
    cx * sy * cz - sx * cy * sz,
    cx * cy * sz + sx * sy * cz,
    cx * cy * cz - sx * sy * sz,
  ];
}
