import type { Place } from './sweep.ts';

/** Side of the square texture, pixels. */
export const textureSize = 1024;

/** A rectangle of the texture, in pixels from its upper left corner. */
export interface Region {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/**
 * Where each part is painted: along the part to the right, across it downwards. Both flanks of a
 * part share their picture, so nothing has a seam. Strips as wide as the texture may be repeated.
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

/** Pixels at a region's upper and lower edge that belong to it and are not reached. */
const margin = 3;

/** 0 on top of an ellipse, 1 underneath, the same on both flanks. */
function fromTop(angle: number): number {
  return Math.acos(Math.min(1, Math.max(-1, Math.sin(angle)))) / Math.PI;
}

/** 0 on the side away from `side`, 1 toward it, the same above and below. */
export function fromFront(angle: number): number {
  return (1 + Math.cos(angle)) / 2;
}

/**
 * @param along of the stations, what is at the region's left edge and at its right edge
 * @param repeats how often the picture comes; more than once only for a strip as wide as the texture
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
