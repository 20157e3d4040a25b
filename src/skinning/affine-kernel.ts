import { flushSubnormal } from '../core/float32.ts';
import type { VertexStreams } from './method.ts';

const { fround } = Math;

/**
 * Applies the 3 × 4 matrix `rows` to a vertex: the point by its rows, the normal by its cofactors
 * (the inverse transpose times the determinant, of which only the sign is kept), normalized.
 * Mirrors `transformVertex` of shaders/lib/affine.glsl, operation by operation, in float32.
 */
export function transformVertex(
  rows: Float32Array,
  rest: VertexStreams,
  vertex: number,
  out: VertexStreams,
): void {
  transformPoint(rows, rest, vertex, out);
  writeCofactors(rows);
  transformNormalBy(cofactors, 0, rest, vertex, out);
}

/** Transforms the point by the three rows of four at the start of `rows`. */
export function transformPoint(
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
}

/**
 * Transforms the normal by three rows of four, starting at `from` (the fourth number is not read),
 * and normalizes it.
 */
export function transformNormalBy(
  rows: Float32Array,
  from: number,
  rest: VertexStreams,
  vertex: number,
  out: VertexStreams,
): void {
  const at = vertex * 3;
  const { normals } = out;
  const nx = rest.normals[at]!;
  const ny = rest.normals[at + 1]!;
  const nz = rest.normals[at + 2]!;
  const x = dot(rows, from, nx, ny, nz);
  const y = dot(rows, from + 4, nx, ny, nz);
  const z = dot(rows, from + 8, nx, ny, nz);
  const squared = fround(fround(fround(x * x) + fround(y * y)) + fround(z * z));
  if (squared > smallestSquare) {
    const scale = fround(1 / fround(Math.sqrt(squared)));
    normals[at] = flushSubnormal(fround(x * scale));
    normals[at + 1] = flushSubnormal(fround(y * scale));
    normals[at + 2] = flushSubnormal(fround(z * scale));
  } else {
    normals[at] = 0;
    normals[at + 1] = 1;
    normals[at + 2] = 0;
  }
}

/** Writes the cofactors of the matrix's upper 3 × 3, negated if its determinant is negative. */
function writeCofactors(rows: Float32Array): void {
  writeCross(rows, 4, 8, 0);
  writeCross(rows, 8, 0, 4);
  writeCross(rows, 0, 4, 8);
  if (dot(cofactors, 0, rows[0]!, rows[1]!, rows[2]!) >= 0) return;
  for (let i = 0; i < 12; i++) cofactors[i] = -cofactors[i]!;
}

/** A normal with a smaller squared length has no direction left; +y replaces it. */
const smallestSquare = fround(1e-30);

/** (3 × 4) rows of cofactors. */
const cofactors = new Float32Array(12);

/** Writes the cross product of two rows of the matrix as one row of cofactors. */
function writeCross(rows: Float32Array, a: number, b: number, target: number): void {
  for (let i = 0; i < 3; i++) {
    const j = i === 2 ? 0 : i + 1;
    const k = j === 2 ? 0 : j + 1;
    const left = fround(rows[a + j]! * rows[b + k]!);
    const right = fround(rows[a + k]! * rows[b + j]!);
    cofactors[target + i] = left - right;
  }
}

function dot(rows: Float32Array, row: number, x: number, y: number, z: number): number {
  const xy = fround(fround(rows[row]! * x) + fround(rows[row + 1]! * y));
  return fround(xy + fround(rows[row + 2]! * z));
}
