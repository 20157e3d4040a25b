/**
 * Order of the product: 'xyz' is Rx · Ry · Rz (z is applied first), 'zyx' is Rz · Ry · Rx (x
 * first).
 */
export type EulerProduct = 'xyz' | 'zyx';

/**
 * If the cosine of y is smaller, x and z rotate about the same axis: z is kept, and x takes the
 * rest.
 */
const gimbal = 1e-6;
const turn = 2 * Math.PI;

/**
 * Returns the angles x, y, z of a rotation. Two triples give the same rotation, each angle up to
 * full turns; the one nearest to `near` is returned. (Shoemake 1994, "Euler angle conversion",
 * Graphics Gems IV.)
 *
 * @param rotation column-major 4 × 4, or its first eleven elements
 */
export function extractEuler(
  rotation: ArrayLike<number>,
  product: EulerProduct,
  near: readonly number[],
): [number, number, number] {
  const angles: [number, number, number] = [0, 0, 0];
  writeEuler(rotation, product, near, angles);
  return angles;
}

/** Like `extractEuler`; writes the angles (3), which may be those of `near`. */
export function writeEuler(
  r: ArrayLike<number>,
  product: EulerProduct,
  near: ArrayLike<number>,
  angles: Numbers,
): void {
  const kx = near[0]!;
  const ky = near[1]!;
  const kz = near[2]!;
  if (product === 'zyx') {
    const cosine = Math.hypot(r[6]!, r[10]!);
    const y = Math.atan2(-r[2]!, cosine);
    if (cosine < gimbal) {
      const x = y > 0 ? kz + Math.atan2(r[4]!, r[5]!) : Math.atan2(-r[4]!, r[5]!) - kz;
      write(angles, nearest(x, kx), nearest(y, ky), kz);
    } else writeNearer(angles, Math.atan2(r[6]!, r[10]!), y, Math.atan2(r[1]!, r[0]!), kx, ky, kz);
    return;
  }
  const cosine = Math.hypot(r[0]!, r[4]!);
  const y = Math.atan2(r[8]!, cosine);
  if (cosine < gimbal) {
    const sum = Math.atan2(r[1]!, r[5]!);
    write(angles, nearest(y > 0 ? sum - kz : kz - sum, kx), nearest(y, ky), kz);
  } else writeNearer(angles, Math.atan2(-r[9]!, r[10]!), y, Math.atan2(-r[4]!, r[0]!), kx, ky, kz);
}

/** Numbers that can be written, of an array of either kind. */
type Numbers = Float64Array | number[];

/** Chooses between (x, y, z) and (x + π, π − y, z + π), which are the same rotation. */
function writeNearer(
  angles: Numbers,
  x: number,
  y: number,
  z: number,
  kx: number,
  ky: number,
  kz: number,
): void {
  const x1 = nearest(x, kx);
  const y1 = nearest(y, ky);
  const z1 = nearest(z, kz);
  const x2 = nearest(x + Math.PI, kx);
  const y2 = nearest(Math.PI - y, ky);
  const z2 = nearest(z + Math.PI, kz);
  const first = Math.abs(x1 - kx) + Math.abs(y1 - ky) + Math.abs(z1 - kz);
  const second = Math.abs(x2 - kx) + Math.abs(y2 - ky) + Math.abs(z2 - kz);
  if (second < first) write(angles, x2, y2, z2);
  else write(angles, x1, y1, z1);
}

function write(angles: Numbers, x: number, y: number, z: number): void {
  angles[0] = x;
  angles[1] = y;
  angles[2] = z;
}

/** The angle, up to full turns, that is nearest to another. */
function nearest(angle: number, to: number): number {
  return angle - turn * Math.round((angle - to) / turn);
}
