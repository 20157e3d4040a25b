import type { Morph } from '../../core/morph.ts';
import type { BinaryWriter } from '../binary/binary-writer.ts';
import { encodeName } from './encode-name.ts';
import { mirrored } from './mirror.ts';
import type { MmdMorphs } from './mmd-parts.ts';

/** Writes the base, with positions, and the other morphs, with offsets of entries of the base. */
export function writeMorphs(
  out: BinaryWriter,
  names: readonly string[],
  { basePoints, basePositions, listed }: MmdMorphs,
  morphs: readonly Morph[],
): void {
  const baseIndex = listed.findIndex(({ panel }) => panel === 0);
  const entryOf = new Map<number, number>();
  basePoints.forEach((point, entry) => {
    if (!entryOf.has(point)) entryOf.set(point, entry);
  });
  out.u16(listed.length);
  listed.forEach(({ panel, morph }, index) => {
    if (index === baseIndex) writeMorph(index, panel, [...basePoints], basePositions);
    else {
      const { vertices, offsets } = morphs[morph] ?? { vertices: [], offsets: [] };
      const entries = Array.from(vertices, (vertex) => entryOf.get(vertex)!);
      writeMorph(index, panel, entries, offsets);
    }
  });

  function writeMorph(
    index: number,
    panel: number,
    entries: readonly number[],
    vectors: ArrayLike<number>,
  ): void {
    out.bytes(encodeName(names[index]!, 20));
    out.u32(entries.length);
    out.u8(panel);
    entries.forEach((entry, at) => {
      out.u32(entry);
      out.f32(vectors[at * 3]!, vectors[at * 3 + 1]!, mirrored(vectors[at * 3 + 2]!));
    });
  }
}
