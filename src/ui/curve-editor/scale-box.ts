import type { Place, Plot } from './plot.ts';

/** A rectangle in the plot, in pixels. */
export interface Box {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/** A handle of a box: −1, 0 or 1 to the right and downward from its middle. */
export interface BoxHandle {
  readonly across: -1 | 0 | 1;
  readonly down: -1 | 0 | 1;
}

const steps = [-1, 0, 1] as const;

/** The handles at the corners and in the middles of the sides. */
export const boxHandles: readonly BoxHandle[] = steps.flatMap((down) =>
  steps.flatMap((across) => (across === 0 && down === 0 ? [] : [{ across, down }])),
);

/** The distance of the box from the keys that it holds, in pixels, so that keys stay pressable. */
const room = 14;

/** The box around places; null around fewer than two. */
export function boxAround(places: readonly Place[]): Box | null {
  if (places.length < 2) return null;
  const box = places.reduce(
    ({ left, right, top, bottom }, { x, y }) => ({
      left: Math.min(left, x),
      right: Math.max(right, x),
      top: Math.min(top, y),
      bottom: Math.max(bottom, y),
    }),
    { left: Infinity, right: -Infinity, top: Infinity, bottom: -Infinity },
  );
  return {
    left: box.left - room,
    right: box.right + room,
    top: box.top - room,
    bottom: box.bottom + room,
  };
}

export function handlePlace({ left, right, top, bottom }: Box, { across, down }: BoxHandle): Place {
  return {
    x: (left + right) / 2 + (across * (right - left)) / 2,
    y: (top + bottom) / 2 + (down * (bottom - top)) / 2,
  };
}

/** How far from the edges of the plot handles stay, in pixels. */
const edge = 5;

/**
 * The part of a box whose handles are drawn and pressed: what is in the plot, so that each handle is
 * seen although the keys at its side may not be. Null if nothing of the box is in the plot.
 */
export function visibleBox(
  box: Box,
  { width, height }: Pick<Plot, 'width' | 'height'>,
): Box | null {
  const isSeen = box.right > 0 && box.left < width && box.bottom > 0 && box.top < height;
  if (!isSeen) return null;
  const across = (x: number): number => Math.min(Math.max(x, edge), width - edge);
  const down = (y: number): number => Math.min(Math.max(y, edge), height - edge);
  return {
    ...{ left: across(box.left), right: across(box.right) },
    ...{ top: down(box.top), bottom: down(box.bottom) },
  };
}

/** How a drag of a handle scales what is in the box. */
interface BoxScaling {
  /** What stays where it is: the opposite side, in pixels, without the room around the keys. */
  readonly about: Place;
  readonly acrossFactor: number;
  readonly downFactor: number;
}

/**
 * Computes the factors by which a handle follows the pointer. What has no extent is not scaled, and
 * a handle in the middle of a side leaves the other direction alone.
 */
export function scalingOf(box: Box, handle: BoxHandle, from: Place, to: Place): BoxScaling {
  const [left, right] = [box.left + room, box.right - room];
  const [top, bottom] = [box.top + room, box.bottom - room];
  const factor = (toward: number, extent: number, moved: number): number =>
    toward === 0 || extent < 0.5 ? 1 : (extent + toward * moved) / extent;
  return {
    about: { x: handle.across > 0 ? left : right, y: handle.down > 0 ? top : bottom },
    acrossFactor: factor(handle.across, right - left, to.x - from.x),
    downFactor: factor(handle.down, bottom - top, to.y - from.y),
  };
}
