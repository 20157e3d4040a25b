import type { BinaryWriter } from '../binary/binary-writer.ts';

/**
 * Writes the corners of the triangles, and swaps the second and third corner of each, because
 * mirroring reverses the sides of a triangle.
 */
export function writeFaces(out: BinaryWriter, corners: Uint32Array): void {
  out.u32(corners.length);
  for (let first = 0; first < corners.length; first += 3) {
    out.u16(corners[first]!, corners[first + 2]!, corners[first + 1]!);
  }
}
