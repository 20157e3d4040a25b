import { readFileSync } from 'node:fs';
import type { Vector3 } from './vector.ts';

const HEADER_BYTES = 84;
const TRIANGLE_BYTES = 50;
const NORMAL_BYTES = 12;

/** Reads a binary STL: the three corners of each triangle, one triangle after another. */
export function readStl(path: string): Vector3[] {
  const file = readFileSync(path);
  const corners: Vector3[] = [];
  for (let at = HEADER_BYTES; at < file.length; at += TRIANGLE_BYTES) {
    for (let corner = 0; corner < 3; corner++) {
      const start = at + NORMAL_BYTES + corner * 12;
      corners.push([
        file.readFloatLE(start),
        file.readFloatLE(start + 4),
        file.readFloatLE(start + 8),
      ]);
    }
  }
  return corners;
}
