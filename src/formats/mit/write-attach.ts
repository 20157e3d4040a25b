import type { Skeleton } from '../../core/skeleton.ts';
import type { Skin } from '../../core/skin.ts';
import { encodeLines, writeFloat32 } from '../text/write-number.ts';

/** Writes the columns of all joints except the file's first, for which the format has no column. */
export function writeAttach(skin: Skin, skeleton: Skeleton): Uint8Array {
  const row = new Float32Array(skeleton.jointCount);
  const lines: string[] = [];
  for (let point = 0; point + 1 < skin.start.length; point++) {
    row.fill(0);
    for (let i = skin.start[point]!; i < skin.start[point + 1]!; i++) {
      const joint = skin.paletteJoint[skin.entries[i]!]!;
      const source = skeleton.sourceIndex[joint]!;
      row[source] = row[source]! + skin.weights[i]!;
    }
    lines.push(Array.from(row.subarray(1), writeFloat32).join(' '));
  }
  return encodeLines(lines);
}
