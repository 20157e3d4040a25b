/** From MMD's left-handed space to Sinew's, or back: z is turned round. */

type Triple = readonly [number, number, number];

/** Subtracted from 0, so that 0 stays 0. */
export function mirrored(z: number): number {
  return 0 - z;
}

export function mirrorPoint([x, y, z]: Triple): [number, number, number] {
  return [x, y, mirrored(z)];
}

/** Angles about x, y, z in any order. */
export function mirrorAngles([x, y, z]: Triple): [number, number, number] {
  return [mirrored(x), mirrored(y), z];
}
