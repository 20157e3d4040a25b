import { DofKind, type Skeleton } from './skeleton.ts';

// These functions multiply an affine matrix from the right, in place: the 16 numbers from `at` on.

/** Multiplies the matrix by the joint's rest transform `T(offset) · R(rest)`. */
export function applyRest(
  { restOffsets, restRotations }: Skeleton,
  joint: number,
  matrix: Float64Array,
  at = 0,
): void {
  const offset = joint * 3;
  translate(matrix, at, restOffsets[offset]!, restOffsets[offset + 1]!, restOffsets[offset + 2]!);
  rotateBy(matrix, at, restRotations, joint * 4);
}

/** Multiplies the matrix by the transform of one degree of freedom for the values q. */
export function applyDof(
  { dofKind, dofQ, dofAxis }: Skeleton,
  dof: number,
  q: Float64Array,
  matrix: Float64Array,
  at = 0,
): void {
  const index = dofQ[dof]!;
  const kind = dofKind[dof] as DofKind;
  if (kind === DofKind.ball) {
    rotateBy(matrix, at, q, index);
    return;
  }
  const value = q[index]!;
  const x = dofAxis[dof * 3]!;
  const y = dofAxis[dof * 3 + 1]!;
  const z = dofAxis[dof * 3 + 2]!;
  if (kind === DofKind.slide) translate(matrix, at, x * value, y * value, z * value);
  else {
    const s = Math.sin(0.5 * value);
    rotate(matrix, at, x * s, y * s, z * s, Math.cos(0.5 * value));
  }
}

function translate(matrix: Float64Array, at: number, x: number, y: number, z: number): void {
  for (let i = at; i < at + 3; i++) {
    matrix[i + 12] = matrix[i + 12]! + (matrix[i]! * x + matrix[i + 4]! * y + matrix[i + 8]! * z);
  }
}

/** Rotates by the unit quaternion xyzw that begins at `index`. */
function rotateBy(matrix: Float64Array, at: number, all: Float64Array, index: number): void {
  rotate(matrix, at, all[index]!, all[index + 1]!, all[index + 2]!, all[index + 3]!);
}

/** Rotates by a unit quaternion. */
function rotate(
  matrix: Float64Array,
  at: number,
  x: number,
  y: number,
  z: number,
  w: number,
): void {
  for (let i = at; i < at + 3; i++) {
    const a = matrix[i]!;
    const b = matrix[i + 4]!;
    const c = matrix[i + 8]!;
    matrix[i] = a + 2 * (b * (x * y + z * w) + c * (x * z - y * w) - a * (y * y + z * z));
    matrix[i + 4] = b + 2 * (a * (x * y - z * w) + c * (y * z + x * w) - b * (x * x + z * z));
    matrix[i + 8] = c + 2 * (a * (x * z + y * w) + b * (y * z - x * w) - c * (x * x + y * y));
  }
}
