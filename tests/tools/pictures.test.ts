import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { bundledIds } from '../support/bundled.ts';

/** Width and height of a JPEG, in the segment that starts its frame. */
function sizeOf(jpeg: Buffer): readonly [number, number] {
  for (let at = 2; jpeg[at] === 0xff; at += 2 + jpeg.readUInt16BE(at + 2)) {
    if (jpeg[at + 1] === 0xc0) return [jpeg.readUInt16BE(at + 7), jpeg.readUInt16BE(at + 5)];
  }
  throw new Error('not a baseline JPEG');
}

describe('the pictures of the gallery', () => {
  it.each(bundledIds)('show %s in light and dark colors, in 12 KB each', (id) => {
    const pictures = ['light', 'dark'].map((theme) =>
      readFileSync(new URL(`../../public/data/pictures/${id}-${theme}.jpg`, import.meta.url)),
    );
    expect(pictures[0]!.equals(pictures[1]!)).toBe(false);
    for (const picture of pictures) {
      expect(sizeOf(picture)).toEqual([288, 216]);
      expect(picture.length).toBeLessThan(12 * 1024);
    }
  });
});
