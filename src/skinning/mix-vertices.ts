import { flushSubnormal } from '../core/float32.ts';
import type { Mesh } from '../core/mesh.ts';
import { makeUnit, transformNormalsByCofactors, transformPoints } from './affine-kernel.ts';
import { blockSize } from './blend-matrices.ts';
import type { PosedStreams } from './method.ts';

const { fround } = Math;

/**
 * Moves the vertices of a block from where its matrices put them to where they are in `out`, by a
 * share from 0 to 1: positions and normals change linearly, and normals get unit length again.
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
  mixInto(out.positions, first * 3, end * 3, posed, 0, share);
  if (!out.normals) return;
  copyBlock(mesh.normals, first, end);
  transformNormalsByCofactors(matrices, rest, 0, end - first, posed);
  mixInto(out.normals, first * 3, end * 3, posed, 0, share);
  makeUnit(out.normals, first, end);
}

const rest = new Float32Array(blockSize * 3);
const posed = new Float32Array(blockSize * 3);

function copyBlock(values: Float32Array, first: number, end: number): void {
  for (let i = first * 3, to = 0; i < end * 3; i++, to++) rest[to] = values[i]!;
}

/** Writes `a + share (b − a)` for every number b of a range, in float32. */
function mixInto(
  values: Float32Array,
  first: number,
  end: number,
  others: Float32Array,
  from: number,
  share: number,
): void {
  for (let i = first, at = from; i < end; i++, at++) {
    const other = others[at]!;
    const change = fround(share * fround(values[i]! - other));
    values[i] = flushSubnormal(fround(other + change));
  }
}
