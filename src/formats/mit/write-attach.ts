import type { Skeleton } from '../../core/skeleton.ts';
import type { Skin } from '../../core/skin.ts';
import { encodeLines, writeFloat32 } from '../text/write-number.ts';

/** Writes all columns of all joints but the first in the file, whose weight the format leaves out. */
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
