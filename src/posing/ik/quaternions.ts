import { writeRotationQuaternion } from '../../core/rotation-quaternion.ts';

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
  writeRotationQuaternion(matrix, at, present, 0);
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
