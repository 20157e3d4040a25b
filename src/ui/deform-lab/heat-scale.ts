import type { Compared } from './compared.ts';

/**
 * The difference that has the last color of a heat map, in the character's units: the largest one,
 * rounded up to 1, 2 or 5 times a power of ten, so that colors keep their meaning while a pose changes
 * a little. 0 where nothing differs.
 */
export function heatScale(compared: Compared | null): number {
  const largest = compared?.worst?.difference.largest ?? 0;
  if (largest === 0) return 0;
  const power = 10 ** Math.floor(Math.log10(largest));
  return power * [1, 2, 5, 10].find((step) => step * power >= largest * (1 - 1e-9))!;
}
