import type { BinaryWriter } from '../binary/binary-writer.ts';
import { mirrored } from './mirror.ts';
import type { MmdVertices } from './mmd-parts.ts';

/** Writes `count × (position, normal, uv, bone, bone, weight, edge flag)`, left-handed. */
export function writeVertices(
  out: BinaryWriter,
  positions: Float32Array,
  { normals, uvs, bones, weights, edgeFlags }: MmdVertices,
): void {
  const count = positions.length / 3;
  out.u32(count);
  for (let vertex = 0; vertex < count; vertex++) {
    writeMirrored(positions, vertex);
    writeMirrored(normals, vertex);
    out.f32(uvs[vertex * 2]!, uvs[vertex * 2 + 1]!);
    out.u16(bones[vertex * 2]!, bones[vertex * 2 + 1]!);
    out.u8(weights[vertex]!, edgeFlags[vertex]!);
  }

  function writeMirrored(triples: Float32Array, index: number): void {
    const at = index * 3;
    out.f32(triples[at]!, triples[at + 1]!, mirrored(triples[at + 2]!));
  }
}
