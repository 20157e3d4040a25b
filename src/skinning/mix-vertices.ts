import { flushSubnormal } from '../core/float32.ts';
import type { Mesh } from '../core/mesh.ts';
import { makeUnit, transformNormalsByCofactors, transformPoints } from './affine-kernel.ts';
import { blockSize } from './blend-matrices.ts';
import type { PosedStreams } from './method.ts';

const { fround } = Math;

/**
 * Moves the vertices of a block from where its matrices put them to where they are in `out`, by a
 * share from 0 to 1: positions and normals change linearly, and normals get unit length again. This
 * mirrors the end of shaders/skinning/dual-quaternion.glsl.
 *
 * @param matrices (12 numbers a vertex, row by row) of the block, from its beginning
 * @param out read and written
 */
export function mixBlock(
  matrices: Float32Array,
  mesh: Mesh,
  first: number,
  end: number,
  share: number,
  out: PosedStreams,
): void {
  copyBlock(mesh.positions, first, end);
  transformPoints(matrices, rest, 0, end - first, posed);
  mixRange(posed, share, out.positions, first * 3, end * 3);
  if (!out.normals) return;
  copyBlock(mesh.normals, first, end);
  transformNormalsByCofactors(matrices, rest, 0, end - first, posed);
  mixRange(posed, share, out.normals, first * 3, end * 3);
  makeUnit(out.normals, first, end);
}

/** Does the same for all vertices, from where they are in `others`. */
export function mixVertices(others: PosedStreams, share: number, out: PosedStreams): void {
  mixRange(others.positions, share, out.positions, 0, out.positions.length);
  if (!out.normals) return;
  mixRange(others.normals!, share, out.normals, 0, out.normals.length);
  makeUnit(out.normals, 0, out.normals.length / 3);
}

const rest = new Float32Array(blockSize * 3);
const posed = new Float32Array(blockSize * 3);

function copyBlock(values: Float32Array, first: number, end: number): void {
  for (let i = first * 3, to = 0; i < end * 3; i++, to++) rest[to] = values[i]!;
}

/** Writes `a + share (b − a)` for every number b of a range, in float32; a is from 0 on. */
function mixRange(
  others: Float32Array,
  share: number,
  values: Float32Array,
  first: number,
  end: number,
): void {
  for (let i = first, from = 0; i < end; i++, from++) {
    const other = others[from]!;
    const change = fround(share * fround(values[i]! - other));
    values[i] = flushSubnormal(fround(other + change));
  }
}
