/**
 * Writes the rotation vector log(R · rotation⁻¹), from an orientation to that of a matrix, from 0 to
 * π long.
 *
 * @param rotation unit quaternion xyzw
 * @param matrix column-major 4 × 4 from `at` on; its rotation is R
 * @param turn (3) in the space in which both are given, written
 */
export function turnBetween(
  rotation: readonly [number, number, number, number],
  matrix: Float64Array,
  at: number,
  turn: Float64Array,
): void {
  writeQuaternion(matrix, at, present);
  const ax = -rotation[0];
  const ay = -rotation[1];
  const az = -rotation[2];
  const aw = rotation[3];
  const bx = present[0]!;
  const by = present[1]!;
  const bz = present[2]!;
  const bw = present[3]!;
  const x = bw * ax + bx * aw + by * az - bz * ay;
  const y = bw * ay - bx * az + by * aw + bz * ax;
  const z = bw * az + bx * ay - by * ax + bz * aw;
  const w = bw * aw - bx * ax - by * ay - bz * az;
  const sine = Math.sqrt(x * x + y * y + z * z);
  const scale = (w < 0 ? -1 : 1) * (sine > 1e-12 ? (2 * Math.atan2(sine, Math.abs(w))) / sine : 2);
  turn[0] = x * scale;
  turn[1] = y * scale;
  turn[2] = z * scale;
}

const present = new Float64Array(4);

/** Writes the unit quaternion xyzw of a rotation matrix (Shepperd 1978). */
function writeQuaternion(m: Float64Array, at: number, q: Float64Array): void {
  const xx = m[at]!;
  const yy = m[at + 5]!;
  const zz = m[at + 10]!;
  const trace = xx + yy + zz;
  // The largest of the four components is computed first, because the others are divided by it.
  if (trace >= xx && trace >= yy && trace >= zz) {
    const w = Math.sqrt(1 + trace);
    q[3] = 0.5 * w;
    q[0] = (0.5 * (m[at + 6]! - m[at + 9]!)) / w;
    q[1] = (0.5 * (m[at + 8]! - m[at + 2]!)) / w;
    q[2] = (0.5 * (m[at + 1]! - m[at + 4]!)) / w;
    return;
  }
  const i = xx >= yy && xx >= zz ? 0 : yy >= zz ? 1 : 2;
  const j = (i + 1) % 3;
  const k = (i + 2) % 3;
  const element = (row: number, column: number): number => m[at + column * 4 + row]!;
  const own = Math.sqrt(1 + element(i, i) - element(j, j) - element(k, k));
  q[i] = 0.5 * own;
  q[3] = (0.5 * (element(k, j) - element(j, k))) / own;
  q[j] = (0.5 * (element(j, i) + element(i, j))) / own;
  q[k] = (0.5 * (element(k, i) + element(i, k))) / own;
}
