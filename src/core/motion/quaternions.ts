// Unit quaternions xyzw in float64, each the four numbers of an array from an index on. Nothing is
// allocated here, because rotations are evaluated in every frame.

/** Writes the four numbers from one array to another. */
export function copyRotation(out: Float64Array, from: Float64Array, at: number): void {
  for (let i = 0; i < 4; i++) out[i] = from[at + i]!;
}

/** Writes the product a · b; `out` may be one of them. */
export function multiply(
  out: Float64Array,
  a: Float64Array,
  aAt: number,
  b: Float64Array,
  bAt: number,
): void {
  const ax = a[aAt]!;
  const ay = a[aAt + 1]!;
  const az = a[aAt + 2]!;
  const aw = a[aAt + 3]!;
  const bx = b[bAt]!;
  const by = b[bAt + 1]!;
  const bz = b[bAt + 2]!;
  const bw = b[bAt + 3]!;
  out[0] = aw * bx + ax * bw + ay * bz - az * by;
  out[1] = aw * by + ay * bw + az * bx - ax * bz;
  out[2] = aw * bz + az * bw + ax * by - ay * bx;
  out[3] = aw * bw - ax * bx - ay * by - az * bz;
}

/** Writes a⁻¹ · b: the turn from a to b, as a sees it. */
export function turnBetween(
  out: Float64Array,
  a: Float64Array,
  aAt: number,
  b: Float64Array,
  bAt: number,
): void {
  inverse[0] = -a[aAt]!;
  inverse[1] = -a[aAt + 1]!;
  inverse[2] = -a[aAt + 2]!;
  inverse[3] = a[aAt + 3]!;
  multiply(out, inverse, 0, b, bAt);
}

const inverse = new Float64Array(4);

/**
 * The angle in radians between two quaternions as points of the sphere: half the turn between them,
 * from 0 to π. Unlike the arc cosine of their product, it is exact where they are nearly equal.
 */
export function arcBetween(a: Float64Array, aAt: number, b: Float64Array, bAt: number): number {
  let sum = 0;
  let difference = 0;
  for (let i = 0; i < 4; i++) {
    sum += (a[aAt + i]! + b[bAt + i]!) ** 2;
    difference += (a[aAt + i]! - b[bAt + i]!) ** 2;
  }
  return 2 * Math.atan2(Math.sqrt(difference), Math.sqrt(sum));
}

/** The angle in radians of the turn between two rotations, from 0 to π, whatever their signs. */
export function turnAngle(a: Float64Array, b: Float64Array): number {
  const arc = arcBetween(a, 0, b, 0);
  return 2 * Math.min(arc, Math.PI - arc);
}

/** The arc below which two quaternions, or a quaternion and an opposite, are not told apart. */
const tiny = 1e-12;

/**
 * Writes the point at a fraction of the arc from a to b, without going the other way about to −b;
 * fractions outside 0 to 1 go on along the circle. (Shoemake 1985, "Animating rotation with
 * quaternion curves".) `out` may be a or b.
 */
export function slerp(
  out: Float64Array,
  a: Float64Array,
  aAt: number,
  b: Float64Array,
  bAt: number,
  fraction: number,
): void {
  const arc = arcBetween(a, aAt, b, bAt);
  if (arc < tiny) {
    for (let i = 0; i < 4; i++) out[i] = a[aAt + i]!;
    return;
  }
  if (Math.PI - arc < tiny) {
    // Opposites have no arc of their own: the way goes through a quaternion at a right angle.
    const [cosine, sine] = [Math.cos(Math.PI * fraction), Math.sin(Math.PI * fraction)];
    const [x, y, z, w] = [a[aAt]!, a[aAt + 1]!, a[aAt + 2]!, a[aAt + 3]!];
    out[0] = cosine * x - sine * y;
    out[1] = cosine * y + sine * x;
    out[2] = cosine * z - sine * w;
    out[3] = cosine * w + sine * z;
    return;
  }
  const sine = Math.sin(arc);
  const fromA = Math.sin((1 - fraction) * arc) / sine;
  const fromB = Math.sin(fraction * arc) / sine;
  for (let i = 0; i < 4; i++) out[i] = fromA * a[aAt + i]! + fromB * b[bAt + i]!;
}

/** Writes the logarithm of a quaternion: (3) its unit axis times half its angle, from 0 to π. */
export function logarithm(out: Float64Array, q: Float64Array): void {
  const length = Math.hypot(q[0]!, q[1]!, q[2]!);
  const factor = length === 0 ? 0 : Math.atan2(length, q[3]!) / length;
  for (let i = 0; i < 3; i++) out[i] = factor * q[i]!;
}

/** Writes the quaternion whose logarithm is a vector (3) times a factor. */
export function exponential(out: Float64Array, vector: Float64Array, factor: number): void {
  const half = factor * Math.hypot(vector[0]!, vector[1]!, vector[2]!);
  // The sine of half, divided by half, is 1 at 0.
  const scale = half === 0 ? factor : (factor * Math.sin(half)) / half;
  for (let i = 0; i < 3; i++) out[i] = scale * vector[i]!;
  out[3] = Math.cos(half);
}
