import { flushSubnormal } from '../core/float32.ts';

const { fround, sqrt } = Math;

// These functions mirror shaders/lib/affine.glsl, operation by operation, in float32: change one
// with the other. They work on a range of vertices; `matrices` has a 3 × 4 matrix for each, 12
// numbers row by row, beginning with that of vertex `first`.

/** Transforms points by their matrices. */
export function transformPoints(
  matrices: Float32Array,
  points: Float32Array,
  first: number,
  end: number,
  out: Float32Array,
): void {
  for (let at = first * 3, m = 0; at < end * 3; at += 3, m += 12) {
    const x = points[at]!;
    const y = points[at + 1]!;
    const z = points[at + 2]!;
    out[at] = flushSubnormal(applyRow(matrices, m, x, y, z));
    out[at + 1] = flushSubnormal(applyRow(matrices, m + 4, x, y, z));
    out[at + 2] = flushSubnormal(applyRow(matrices, m + 8, x, y, z));
  }
}

/**
 * Transforms normals by the cofactors of their matrices (the inverse transpose times the
 * determinant, of which only the sign is kept), and normalizes them.
 */
export function transformNormalsByCofactors(
  matrices: Float32Array,
  normals: Float32Array,
  first: number,
  end: number,
  out: Float32Array,
): void {
  for (let at = first * 3, m = 0; at < end * 3; at += 3, m += 12) {
    const ax = matrices[m]!;
    const ay = matrices[m + 1]!;
    const az = matrices[m + 2]!;
    const bx = matrices[m + 4]!;
    const by = matrices[m + 5]!;
    const bz = matrices[m + 6]!;
    const cx = matrices[m + 8]!;
    const cy = matrices[m + 9]!;
    const cz = matrices[m + 10]!;
    // The rows of the cofactors are the cross products b × c, c × a and a × b.
    const ux = minor(by, cz, bz, cy);
    const uy = minor(bz, cx, bx, cz);
    const uz = minor(bx, cy, by, cx);
    const nx = normals[at]!;
    const ny = normals[at + 1]!;
    const nz = normals[at + 2]!;
    const x = dot(ux, uy, uz, nx, ny, nz);
    const y = dot(minor(cy, az, cz, ay), minor(cz, ax, cx, az), minor(cx, ay, cy, ax), nx, ny, nz);
    const z = dot(minor(ay, bz, az, by), minor(az, bx, ax, bz), minor(ax, by, ay, bx), nx, ny, nz);
    const side = dot(ux, uy, uz, ax, ay, az) < 0 ? -1 : 1;
    out[at] = side * x;
    out[at + 1] = side * y;
    out[at + 2] = side * z;
  }
  makeUnit(out, first, end);
}

/** A normal with a smaller squared length has no direction left; +y replaces it. */
const smallestSquare = fround(1e-30);

/** Normalizes normals. */
export function makeUnit(normals: Float32Array, first: number, end: number): void {
  for (let at = first * 3; at < end * 3; at += 3) {
    const x = normals[at]!;
    const y = normals[at + 1]!;
    const z = normals[at + 2]!;
    const squared = dot(x, y, z, x, y, z);
    if (squared > smallestSquare) {
      const scale = fround(1 / fround(sqrt(squared)));
      normals[at] = flushSubnormal(fround(x * scale));
      normals[at + 1] = flushSubnormal(fround(y * scale));
      normals[at + 2] = flushSubnormal(fround(z * scale));
    } else {
      normals[at] = 0;
      normals[at + 1] = 1;
      normals[at + 2] = 0;
    }
  }
}

/** Multiplies a row of a matrix by (x, y, z, 1). */
export function applyRow(rows: Float32Array, row: number, x: number, y: number, z: number): number {
  return fround(dot(rows[row]!, rows[row + 1]!, rows[row + 2]!, x, y, z) + rows[row + 3]!);
}

export function dot(
  ax: number,
  ay: number,
  az: number,
  bx: number,
  by: number,
  bz: number,
): number {
  return fround(fround(fround(ax * bx) + fround(ay * by)) + fround(az * bz));
}

/** The determinant a d − b c of two rows a b and c d, whose terms are given in the order of use. */
function minor(a: number, d: number, b: number, c: number): number {
  return fround(fround(a * d) - fround(b * c));
}
