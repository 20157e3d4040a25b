import { flushSubnormal } from '../core/float32.ts';
import type { VertexStreams } from './method.ts';

const { fround } = Math;

/**
 * Applies the 3 × 4 matrix `rows` to a vertex: the point by its rows, the normal by its cofactors
 * (the inverse transpose times the determinant, whose sign alone is kept), then made unit. Mirrors
 * `transformVertex` of shaders/lib/affine.glsl, operation by operation, in float32.
 */
export function transformVertex(
  rows: Float32Array,
  rest: VertexStreams,
  vertex: number,
  out: VertexStreams,
): void {
  const at = vertex * 3;
  const x = rest.positions[at]!;
  const y = rest.positions[at + 1]!;
  const z = rest.positions[at + 2]!;
  for (let row = 0; row < 3; row++) {
    const r = row * 4;
    const xy = fround(fround(rows[r]! * x) + fround(rows[r + 1]! * y));
    const xyz = fround(xy + fround(rows[r + 2]! * z));
    out.positions[at + row] = flushSubnormal(fround(xyz + rows[r + 3]!));
  }
  transformNormal(rows, rest.normals, at, out.normals);
}

function transformNormal(
  rows: Float32Array,
  rest: Float32Array,
  at: number,
  out: Float32Array,
): void {
  writeCross(rows, 4, 8, 0);
  writeCross(rows, 8, 0, 3);
  writeCross(rows, 0, 4, 6);
  const determinant = dot(rows[0]!, rows[1]!, rows[2]!, 0);
  const side = determinant < 0 ? -1 : 1;
  const nx = rest[at]!;
  const ny = rest[at + 1]!;
  const nz = rest[at + 2]!;
  const x = side * dot(nx, ny, nz, 0);
  const y = side * dot(nx, ny, nz, 3);
  const z = side * dot(nx, ny, nz, 6);
  const squared = fround(fround(fround(x * x) + fround(y * y)) + fround(z * z));
  if (squared > smallestSquare) {
    const scale = fround(1 / fround(Math.sqrt(squared)));
    out[at] = flushSubnormal(fround(x * scale));
    out[at + 1] = flushSubnormal(fround(y * scale));
    out[at + 2] = flushSubnormal(fround(z * scale));
  } else {
    out[at] = 0;
    out[at + 1] = 1;
    out[at + 2] = 0;
  }
}

/** Below this a normal has no direction left; +y is put in its place. */
const smallestSquare = fround(1e-30);

/** (3 × 3) rows of cofactors. */
const cofactors = new Float32Array(9);

/** The cross product of two rows of the matrix, as one row of cofactors. */
function writeCross(rows: Float32Array, a: number, b: number, target: number): void {
  for (let i = 0; i < 3; i++) {
    const j = i === 2 ? 0 : i + 1;
    const k = j === 2 ? 0 : j + 1;
    const left = fround(rows[a + j]! * rows[b + k]!);
    const right = fround(rows[a + k]! * rows[b + j]!);
    cofactors[target + i] = left - right;
  }
}

function dot(x: number, y: number, z: number, row: number): number {
  const xy = fround(fround(cofactors[row]! * x) + fround(cofactors[row + 1]! * y));
  return fround(xy + fround(cofactors[row + 2]! * z));
}
