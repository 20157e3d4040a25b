/**
 * Writes the unit quaternion xyzw of a rotation (Shepperd 1978, "Quaternion from rotation matrix").
 * No digits are lost at any angle, also near half a turn.
 *
 * @param m column-major 4 × 4 from `at` on, whose upper 3 × 3 is a rotation
 * @param q written from `to` on
 */
export function writeRotationQuaternion(
  m: Float64Array,
  at: number,
  q: Float64Array | Float32Array,
  to: number,
): void {
  const xx = m[at]!;
  const yy = m[at + 5]!;
  const zz = m[at + 10]!;
  const trace = xx + yy + zz;
  // The largest of the four components is computed first, because the others are divided by it.
  if (trace >= xx && trace >= yy && trace >= zz) {
    const w = Math.sqrt(1 + trace);
    q[to + 3] = 0.5 * w;
    q[to] = (0.5 * (m[at + 6]! - m[at + 9]!)) / w;
    q[to + 1] = (0.5 * (m[at + 8]! - m[at + 2]!)) / w;
    q[to + 2] = (0.5 * (m[at + 1]! - m[at + 4]!)) / w;
    return;
  }
  const i = xx >= yy && xx >= zz ? 0 : yy >= zz ? 1 : 2;
  const j = (i + 1) % 3;
  const k = (i + 2) % 3;
  const element = (row: number, column: number): number => m[at + column * 4 + row]!;
  const own = Math.sqrt(1 + element(i, i) - element(j, j) - element(k, k));
  q[to + i] = 0.5 * own;
  q[to + 3] = (0.5 * (element(k, j) - element(j, k))) / own;
  q[to + j] = (0.5 * (element(j, i) + element(i, j))) / own;
  q[to + k] = (0.5 * (element(k, i) + element(i, k))) / own;
}
