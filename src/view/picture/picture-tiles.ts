import { Failure } from '../../core/failure.ts';
import type { CaptureSize } from '../viewer.ts';

/** A rectangle of a picture in its own pixels, from the lower left corner. */
export interface Tile extends CaptureSize {
  readonly x: number;
  readonly y: number;
}

/** A picture up to this many samples is drawn in one piece; a larger one in squares of this side. */
const [mostAtOnce, tileSide] = [2 ** 23, 2048];
/** An encoder needs each pixel twice, at 4 bytes. */
const mostPixels = 100e6;
const longestSide = 16_384;

/**
 * Divides a picture into tiles that can be drawn, by rows from the lower left corner. Tiles begin at
 * even pixels, because shaders compare the four pixels of a square.
 *
 * @param samples per side of a pixel
 * @param limit the most samples that a tile may have on a side; chosen by size if absent
 */
export function tilesOf({ width, height }: CaptureSize, samples: number, limit?: number): Tile[] {
  const isSmall = width * height * samples * samples <= mostAtOnce;
  const most = limit ?? (isSmall ? Infinity : tileSide);
  const side = Math.max(2, 2 * Math.floor(most / samples / 2));
  const tiles: Tile[] = [];
  for (let y = 0; y < height; y += side) {
    for (let x = 0; x < width; x += side) {
      tiles.push({ x, y, width: Math.min(side, width - x), height: Math.min(side, height - y) });
    }
  }
  return tiles;
}

/** Throws a `Failure` for a picture that a browser has no room for. */
export function checkPictureSize({ width, height }: CaptureSize): void {
  const size = `${width.toLocaleString('en')} × ${height.toLocaleString('en')} pixels`;
  if (width * height > mostPixels) {
    const gigabytes = ((width * height * 8) / 1e9).toFixed(1);
    throw new Failure(
      `A picture of ${size} would need ${gigabytes} GB of memory; at most 100 megapixels are made`,
    );
  }
  if (Math.max(width, height) > longestSide) {
    const most = longestSide.toLocaleString('en');
    throw new Failure(`A picture of ${size} is too long; a side has at most ${most} pixels`);
  }
}
