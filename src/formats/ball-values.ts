import { DofKind, type Skeleton } from '../core/skeleton.ts';

export type Triple = [x: number, y: number, z: number];
export type Quaternion = [x: number, y: number, z: number, w: number];

/** A joint's rotation in JSON: three angles, or a quaternion. */
export type BallJson = Triple | Quaternion;

/** Returns where in q a joint's ball has its four values, or -1 if it has no ball. */
export function ballValue(skeleton: Skeleton, joint: number): number {
  for (let dof = skeleton.dofStart[joint]!; dof < skeleton.dofStart[joint + 1]!; dof++) {
    if (skeleton.dofKind[dof] === DofKind.ball) return skeleton.dofQ[dof]!;
  }
  return -1;
}

/** A quaternion whose length is this close to 1 counts as unit and keeps its exact bits. */
const unitTolerance = 1e-12;

/**
 * Returns a unit quaternion: the given one normalized, or that of the angles, Rx · Ry · Rz. The
 * zero quaternion gives NaN.
 */
export function quaternionOf(value: BallJson): Quaternion {
  if (value.length === 4) {
    const length = Math.hypot(...value);
    const divisor = Math.abs(length - 1) <= unitTolerance ? 1 : length;
    return value.map((each) => each / divisor) as Quaternion;
  }
  // Written out, so that the first picture does not have to load a library for quaternions.
  const [sx, sy, sz] = value.map((angle) => Math.sin(angle / 2)) as Triple;
  const [cx, cy, cz] = value.map((angle) => Math.cos(angle / 2)) as Triple;
  return [
    sx * cy * cz + cx * sy * sz,
    cx * sy * cz - sx * cy * sz,
    cx * cy * sz + sx * sy * cz,
    cx * cy * cz - sx * sy * sz,
  ];
}
