import type { Mesh } from '../../core/mesh.ts';
import type { Morph } from '../../core/morph.ts';
import { encodeLines, writeFloat64 } from '../text/write-number.ts';

/**
 * Writes a `.morph`: absolute targets of the vertices that it moves, with the indices of the
 * `.skin`.
 */
export function writeMorph(morph: Morph, mesh: Mesh): Uint8Array {
  return encodeLines([
    ...section('positions', morph.vertices, morph.offsets, mesh.positions),
    ...section('normals', morph.normalVertices, morph.normalOffsets, mesh.normals),
  ]);
}

function section(
  name: string,
  vertices: Uint32Array,
  offsets: Float32Array,
  base: Float32Array,
): string[] {
  const rows = Array.from(vertices, (vertex, index) => {
    const target = [0, 1, 2].map((i) => base[vertex * 3 + i]! + offsets[index * 3 + i]!);
    return `\t${vertex} ${target.map(writeFloat64).join(' ')}`;
  });
  return [`${name} ${vertices.length} {`, ...rows, '}'];
}
