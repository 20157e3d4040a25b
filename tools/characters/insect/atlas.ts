import type { Place } from './sweep.ts';

/** The side of the square texture, in pixels. */
export const textureSize = 1024;

/** A rectangle of the texture, in pixels from its upper left corner. */
export interface Region {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/**
 * The region of each part: along the part to the right, across it downward. Both flanks of a part
 * share their picture, so nothing has a seam. Strips as wide as the texture may be repeated.
 */
export const atlas = {
  abdomen: { left: 0, top: 0, width: 1024, height: 208 },
  thorax: { left: 0, top: 208, width: 640, height: 208 },
  head: { left: 640, top: 208, width: 384, height: 208 },
  wing: { left: 0, top: 416, width: 1024, height: 368 },
  leg: { left: 0, top: 784, width: 1024, height: 80 },
  tarsus: { left: 0, top: 864, width: 1024, height: 32 },
  antenna: { left: 0, top: 896, width: 1024, height: 32 },
  eye: { left: 0, top: 928, width: 512, height: 96 },
  mandible: { left: 512, top: 928, width: 512, height: 96 },
} as const satisfies Readonly<Record<string, Region>>;

/**
 * The rows at a region's upper and lower edge, in pixels, that belong to it but are never sampled.
 */
const margin = 3;

/** Returns 0 on top of an ellipse and 1 underneath, equal on both flanks. */
function fromTop(angle: number): number {
  return Math.acos(Math.min(1, Math.max(-1, Math.sin(angle)))) / Math.PI;
}

/** Returns 0 on the side away from `side` and 1 toward it, equal above and below. */
export function fromFront(angle: number): number {
  return (1 + Math.cos(angle)) / 2;
}

/**
 * @param along the values of the stations at the region's left edge and at its right edge
 * @param repeats how often the picture repeats; more than once only for a strip as wide as the
 * texture
 */
export function placeIn(
  region: Region,
  [start, end]: readonly [number, number],
  across: (angle: number) => number = fromTop,
  repeats = 1,
): Place {
  const inset = region.width < textureSize ? margin : 0;
  return (along, angle) => {
    const x = region.left + inset;
    const u = x + ((along - start) / (end - start)) * repeats * (region.width - 2 * inset);
    const v = region.top + margin + across(angle) * (region.height - 2 * margin);
    return [u / textureSize, 1 - v / textureSize];
  };
}
