import { DofKind, type Skeleton } from './skeleton.ts';

// These functions multiply an affine matrix from the right, in place. Only what changes is
// computed: a rotation about a coordinate axis, for example, mixes two of the columns.

/** Multiplies the matrix by the joint's rest transform `T(offset) · R(rest)`. */
export function applyRest(
  { restOffsets, restRotations }: Skeleton,
  joint: number,
  matrix: Float64Array,
): void {
  const offset = joint * 3;
  translate(matrix, restOffsets[offset]!, restOffsets[offset + 1]!, restOffsets[offset + 2]!);
  rotateByQuaternion(matrix, restRotations, joint * 4);
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
    rotateByQuaternion(matrix, q, at);
    return;
  }
  const value = q[at]!;
  const x = dofAxis[dof * 3]!;
  const y = dofAxis[dof * 3 + 1]!;
  const z = dofAxis[dof * 3 + 2]!;
  if (kind === DofKind.slide) translate(matrix, x * value, y * value, z * value);
  else if (x === 1) turnColumns(matrix, 4, 8, value);
  else if (y === 1) turnColumns(matrix, 8, 0, value);
  else if (z === 1) turnColumns(matrix, 0, 4, value);
  else rotateAbout(matrix, x, y, z, value);
}

function translate(matrix: Float64Array, x: number, y: number, z: number): void {
  for (let row = 0; row < 3; row++) {
    const moved = matrix[row]! * x + matrix[4 + row]! * y + matrix[8 + row]! * z;
    matrix[12 + row] = matrix[12 + row]! + moved;
  }
}

/** Rotates about a coordinate axis, which turns the column at `from` toward that at `to`. */
function turnColumns(matrix: Float64Array, from: number, to: number, angle: number): void {
  const cosine = Math.cos(angle);
  const sine = Math.sin(angle);
  for (let row = 0; row < 3; row++) {
    const a = matrix[from + row]!;
    const b = matrix[to + row]!;
    matrix[from + row] = a * cosine + b * sine;
    matrix[to + row] = b * cosine - a * sine;
  }
}

/** Rotates about a unit axis by an angle in radians, by Rodrigues' formula. */
function rotateAbout(matrix: Float64Array, x: number, y: number, z: number, angle: number): void {
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  const t = 1 - c;
  rotation[0] = x * x * t + c;
  rotation[1] = x * y * t + z * s;
  rotation[2] = x * z * t - y * s;
  rotation[3] = x * y * t - z * s;
  rotation[4] = y * y * t + c;
  rotation[5] = y * z * t + x * s;
  rotation[6] = x * z * t + y * s;
  rotation[7] = y * z * t - x * s;
  rotation[8] = z * z * t + c;
  rotate(matrix);
}

/** Rotates by the unit quaternion xyzw at `at`. */
function rotateByQuaternion(matrix: Float64Array, quaternions: Float64Array, at: number): void {
  const x = quaternions[at]!;
  const y = quaternions[at + 1]!;
  const z = quaternions[at + 2]!;
  const w = quaternions[at + 3]!;
  if (x === 0 && y === 0 && z === 0) return;
  rotation[0] = 1 - 2 * (y * y + z * z);
  rotation[1] = 2 * (x * y + z * w);
  rotation[2] = 2 * (x * z - y * w);
  rotation[3] = 2 * (x * y - z * w);
  rotation[4] = 1 - 2 * (x * x + z * z);
  rotation[5] = 2 * (y * z + x * w);
  rotation[6] = 2 * (x * z + y * w);
  rotation[7] = 2 * (y * z - x * w);
  rotation[8] = 1 - 2 * (x * x + y * y);
  rotate(matrix);
}

/** Multiplies the matrix by `rotation`. */
function rotate(matrix: Float64Array): void {
  for (let row = 0; row < 3; row++) {
    const a = matrix[row]!;
    const b = matrix[4 + row]!;
    const c = matrix[8 + row]!;
    for (let column = 0; column < 3; column++) {
      const r = column * 3;
      matrix[column * 4 + row] = a * rotation[r]! + b * rotation[r + 1]! + c * rotation[r + 2]!;
    }
  }
}

/** (3 × 3) column-major. */
const rotation = new Float64Array(9);
