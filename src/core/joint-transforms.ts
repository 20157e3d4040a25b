import { DofKind, type Skeleton } from './skeleton.ts';

// These functions multiply an affine matrix from the right, in place.

/** Multiplies the matrix by the joint's rest transform `T(offset) · R(rest)`. */
export function applyRest(
  { restOffsets, restRotations }: Skeleton,
  joint: number,
  matrix: Float64Array,
): void {
  const offset = joint * 3;
  translate(matrix, restOffsets[offset]!, restOffsets[offset + 1]!, restOffsets[offset + 2]!);
  rotateBy(matrix, restRotations, joint * 4);
}

/** Multiplies the matrix by the transform of one degree of freedom for the values q. */
export function applyDof(
  { dofKind, dofQ, dofAxis }: Skeleton,
  dof: number,
  q: Float64Array,
  matrix: Float64Array,
): void {
  const at = dofQ[dof]!;
  const kind = dofKind[dof] as DofKind;
  if (kind === DofKind.ball) {
    rotateBy(matrix, q, at);
    return;
  }
  const value = q[at]!;
  const x = dofAxis[dof * 3]!;
  const y = dofAxis[dof * 3 + 1]!;
  const z = dofAxis[dof * 3 + 2]!;
  if (kind === DofKind.slide) translate(matrix, x * value, y * value, z * value);
  else {
    const s = Math.sin(0.5 * value);
    rotate(matrix, x * s, y * s, z * s, Math.cos(0.5 * value));
  }
}

function translate(matrix: Float64Array, x: number, y: number, z: number): void {
  for (let row = 0; row < 3; row++) {
    const moved = matrix[row]! * x + matrix[4 + row]! * y + matrix[8 + row]! * z;
    matrix[12 + row] = matrix[12 + row]! + moved;
  }
}

/** Rotates by the unit quaternion xyzw at `at`. */
function rotateBy(matrix: Float64Array, quaternions: Float64Array, at: number): void {
  const [x, y] = [quaternions[at]!, quaternions[at + 1]!];
  rotate(matrix, x, y, quaternions[at + 2]!, quaternions[at + 3]!);
}

/** Rotates by a unit quaternion. */
function rotate(matrix: Float64Array, x: number, y: number, z: number, w: number): void {
  for (let row = 0; row < 3; row++) {
    const a = matrix[row]!;
    const b = matrix[4 + row]!;
    const c = matrix[8 + row]!;
    matrix[row] = a + 2 * (b * (x * y + z * w) + c * (x * z - y * w) - a * (y * y + z * z));
    matrix[4 + row] = b + 2 * (a * (x * y - z * w) + c * (y * z + x * w) - b * (x * x + z * z));
    matrix[8 + row] = c + 2 * (a * (x * z + y * w) + b * (y * z - x * w) - c * (x * x + y * y));
  }
}
