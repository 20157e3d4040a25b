import fc from 'fast-check';
import { expect, it } from 'vitest';
import { checkPictureSize, tilesOf } from '../../../src/view/picture/picture-tiles.ts';

const side = fc.integer({ min: 1, max: 300 });
const samples = fc.integer({ min: 1, max: 4 });

it('tiles cover every pixel once, begin at even pixels, and keep the limit', () => {
  const limits = fc.integer({ min: 8, max: 64 });
  fc.assert(
    fc.property(side, side, samples, limits, (width, height, count, limit) => {
      const covered = new Uint8Array(width * height);
      for (const tile of tilesOf({ width, height }, count, limit)) {
        expect([tile.x % 2, tile.y % 2]).toEqual([0, 0]);
        expect(Math.max(tile.width, tile.height) * count).toBeLessThanOrEqual(limit);
        for (let y = tile.y; y < tile.y + tile.height; y++) {
          for (let x = tile.x; x < tile.x + tile.width; x++) covered[y * width + x]!++;
        }
      }
      expect(covered.every((count) => count === 1)).toBe(true);
    }),
    { numRuns: 40 },
  );
});

it('a picture of a view is drawn in one piece, and a large one in several', () => {
  expect(tilesOf({ width: 3840, height: 2160 }, 1)).toHaveLength(1);
  expect(tilesOf({ width: 1440, height: 900 }, 2)).toHaveLength(1);
  expect(tilesOf({ width: 3840, height: 2160 }, 2).length).toBeGreaterThan(1);
});

it('a picture that no browser has room for is refused with the reason', () => {
  checkPictureSize({ width: 10_000, height: 10_000 });
  expect(() => checkPictureSize({ width: 16_384, height: 16_384 })).toThrow(/2\.1 GB/);
  expect(() => checkPictureSize({ width: 20_000, height: 100 })).toThrow(/too long/);
});
