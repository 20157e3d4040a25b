import { carriageReturn, lineFeed } from '../text/line-ends.ts';

const tab = 0x09;
const space = 0x20;
const minus = 0x2d;
const slash = 0x2f;
const zero = 0x30;

/** Indices of more digits do not occur, and would not fit 32 bits. */
const mostDigits = 9;

/** Faces of more corners are left to the careful reader. */
const mostCorners = 64;

/** The fields of a corner, `v/vt/vn`. */
const fieldCount = 3;

/**
 * Reads the corners of plain faces: `v`, `v/vt`, `v//vn` or `v/vt/vn`, with indices as the file has
 * them. All state of its loop is in local variables, as in `PlainNumbers`.
 */
export class PlainCorners {
  /** (count × 3) vertex, texture coordinate and normal; 0 stands for one that a corner has not. */
  readonly indices = new Int32Array(mostCorners * fieldCount);
  count = 0;
  hasUvs = false;
  hasNormals = false;

  /**
   * Reads from `start` to the end of the line and returns where that is, or -1 if there is anything
   * else in the line. The file has a line feed after `start`.
   */
  read(bytes: Uint8Array, start: number): number {
    const { indices } = this;
    let at = start;
    let byte = bytes[at]!;
    let corner = 0;
    let hasUvs = false;
    let hasNormals = false;
    for (; ; corner++) {
      while (byte === space || byte === tab) byte = bytes[++at]!;
      if (byte === lineFeed || byte === carriageReturn) break;
      if (corner === mostCorners) return -1;
      for (let field = 0; field < fieldCount; field++) {
        let index = 0;
        if (field > 0) {
          if (byte !== slash) {
            indices[corner * fieldCount + field] = 0;
            continue;
          }
          byte = bytes[++at]!;
          if (byte === slash && field === 1) {
            indices[corner * fieldCount + field] = 0;
            continue;
          }
        }
        const isNegative = byte === minus;
        if (isNegative) byte = bytes[++at]!;
        const firstDigit = at;
        let digit = byte - zero;
        while (digit >= 0 && digit <= 9) {
          index = (index * 10 + digit) | 0;
          byte = bytes[++at]!;
          digit = byte - zero;
        }
        if (index === 0 || at - firstDigit > mostDigits) return -1;
        indices[corner * fieldCount + field] = isNegative ? -index : index;
        if (field === 1) hasUvs = true;
        else if (field === 2) hasNormals = true;
      }
      if (byte !== space && byte !== lineFeed && byte !== carriageReturn && byte !== tab) return -1;
    }
    this.count = corner;
    this.hasUvs = hasUvs;
    this.hasNormals = hasNormals;
    return at;
  }
}
