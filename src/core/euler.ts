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
  const r = (row: number, column: number): number => rotation[column * 4 + row]!;
  const [kx, ky, kz] = [near[0]!, near[1]!, near[2]!];
  if (product === 'zyx') {
    const cosine = Math.hypot(r(2, 1), r(2, 2));
    const y = Math.atan2(-r(2, 0), cosine);
    if (cosine < gimbal) {
      const x = y > 0 ? kz + Math.atan2(r(0, 1), r(1, 1)) : Math.atan2(-r(0, 1), r(1, 1)) - kz;
      return [nearest(x, kx), nearest(y, ky), kz];
    }
    return nearer([Math.atan2(r(2, 1), r(2, 2)), y, Math.atan2(r(1, 0), r(0, 0))], near);
  }
  const cosine = Math.hypot(r(0, 0), r(0, 1));
  const y = Math.atan2(r(0, 2), cosine);
  if (cosine < gimbal) {
    const sum = Math.atan2(r(1, 0), r(1, 1));
    return [nearest(y > 0 ? sum - kz : kz - sum, kx), nearest(y, ky), kz];
  }
  return nearer([Math.atan2(-r(1, 2), r(2, 2)), y, Math.atan2(-r(0, 1), r(0, 0))], near);
}

/** Chooses between (x, y, z) and (x + π, π − y, z + π), which are the same rotation. */
function nearer(
  [x, y, z]: readonly [number, number, number],
  near: readonly number[],
): [number, number, number] {
  const wrapped = (angles: readonly number[]) => {
    const triple = angles.map((angle, axis) => nearest(angle, near[axis]!));
    const distance = triple.reduce((sum, angle, axis) => sum + Math.abs(angle - near[axis]!), 0);
    return { triple: [triple[0]!, triple[1]!, triple[2]!] as [number, number, number], distance };
  };
  const [first, second] = [wrapped([x, y, z]), wrapped([x + Math.PI, Math.PI - y, z + Math.PI])];
  return second.distance < first.distance ? second.triple : first.triple;
}

/** The angle, up to full turns, that is nearest to another. */
function nearest(angle: number, to: number): number {
  return angle - turn * Math.round((angle - to) / turn);
}
