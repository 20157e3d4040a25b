/** Converts between MMD's left-handed space and Sinew's by negating z. */

type Triple = readonly [number, number, number];

/** Subtracts from 0, so that 0 stays 0. */
export function mirrored(z: number): number {
  return 0 - z;
}

export function mirrorPoint([x, y, z]: Triple): [number, number, number] {
  return [x, y, mirrored(z)];
}

/** Angles about x, y, z, for any order of the rotations. */
export function mirrorAngles([x, y, z]: Triple): [number, number, number] {
  return [mirrored(x), mirrored(y), z];
}

/** A quaternion xyzw of the same rotation in the other space. */
export function mirrorRotation([x, y, z, w]: readonly [number, number, number, number]): [
  number,
  number,
  number,
  number,
] {
  return [mirrored(x), mirrored(y), z, w];
}
