import type { Skin } from '../core/skin.ts';

/**
 * The palette entry with the largest weight at a point, the first one if several are equal, or 0 if
 * no weight is above 0.
 */
export function heaviestEntry({ start, entries, weights }: Skin, point: number): number {
  let entry = 0;
  let heaviest = 0;
  for (let i = start[point]!; i < start[point + 1]!; i++) {
    if (weights[i]! <= heaviest) continue;
    heaviest = weights[i]!;
    entry = entries[i]!;
  }
  return entry;
}
