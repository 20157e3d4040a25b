/**
 * Writes the coordinates of a rotation `swing · twist`: the swing's rotation vector about x and y
 * (bend and side), and the twist's angle about z, all in radians; the twist is from −π to π. Where
 * the swing is half a turn, the twist is undefined, and is 0.
 *
 * @param q unit quaternion xyzw
 * @param angles (3) bend, side, twist, written
 */
export function swingTwist(q: Float64Array, angles: Float64Array): void {
  const x = q[0]!;
  const y = q[1]!;
  const z = q[2]!;
  const w = q[3]!;
  const k = swingFactor(Math.sqrt(x * x + y * y), Math.sqrt(z * z + w * w));
  angles[0] = k * (x * w - y * z);
  angles[1] = k * (x * z + y * w);
  angles[2] = 2 * (w < 0 ? Math.atan2(-z, -w) : Math.atan2(z, w));
}

/**
 * Writes the derivatives of the coordinates by a small rotation from the left, `exp(v) · q`.
 *
 * With h = |(x, y)|, p = |(z, w)| and the swing's angle θ = 2 atan2(h, p), the bend is k (x w − y z)
 * and the side k (x z + y w), where k = θ / (h p); and dq = ½ (v, 0) · q.
 *
 * @param rates (3 × 3) a row for each of bend, side and twist, written
 */
export function swingTwistRates(q: Float64Array, rates: Float64Array): void {
  const x = q[0]!;
  const y = q[1]!;
  const z = q[2]!;
  const w = q[3]!;
  const h = Math.sqrt(x * x + y * y);
  const p = Math.max(Math.sqrt(z * z + w * w), leastCosine);
  const k = swingFactor(h, p);
  // k as a function of the squares of h and p: its derivative by h²/2, where p² = 1 − h².
  const slope = h > small ? (2 - k * (p * p - h * h)) / (h * h * p * p) : 8 / 3;
  for (let axis = 0; axis < 3; axis++) {
    const vx = axis === 0 ? 0.5 : 0;
    const vy = axis === 1 ? 0.5 : 0;
    const vz = axis === 2 ? 0.5 : 0;
    const dx = vx * w + vy * z - vz * y;
    const dy = vy * w + vz * x - vx * z;
    const dz = vz * w + vx * y - vy * x;
    const dw = -vx * x - vy * y - vz * z;
    const dk = slope * (x * dx + y * dy);
    rates[axis] = dk * (x * w - y * z) + k * (dx * w + x * dw - dy * z - y * dz);
    rates[3 + axis] = dk * (x * z + y * w) + k * (dx * z + x * dz + dy * w + y * dw);
    rates[6 + axis] = (2 * (w * dz - z * dw)) / (p * p);
  }
}

/** Below this half-angle's sine the series of the swing's factor is exact to rounding. */
const small = 1e-4;
/** Nearer to half a turn the twist would change by more than 1000 times what the joint does. */
const leastCosine = 1e-3;

/** The swing's angle over sin · cos of its half. */
function swingFactor(h: number, p: number): number {
  const cosine = Math.max(p, leastCosine);
  return h > small ? (2 * Math.atan2(h, cosine)) / (h * cosine) : 2 + (4 / 3) * h * h;
}
