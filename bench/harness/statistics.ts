import type { Sample } from './measure.ts';

export interface Spread {
  readonly lower: number;
  readonly median: number;
  readonly upper: number;
}

/** The median and the quartiles, with linear interpolation between neighbors. */
export function spreadOf(values: readonly number[]): Spread {
  const sorted = [...values].sort((a, b) => a - b);
  const at = (part: number): number => {
    const place = part * (sorted.length - 1);
    const low = Math.floor(place);
    const [a, b] = [sorted[low]!, sorted[Math.ceil(place)]!];
    return a + (b - a) * (place - low);
  };
  return { lower: at(0.25), median: at(0.5), upper: at(0.75) };
}

/**
 * How many times as long one contender takes as another, by the rounds in which both ran, in elapsed
 * or processor time.
 */
export function pairedRatio(
  slow: readonly Sample[],
  fast: readonly Sample[],
  clock: 'wall' | 'cpu' = 'wall',
): Spread {
  return spreadOf(slow.map((sample, round) => sample[clock]! / fast[round]![clock]!));
}

export function leastWall(samples: readonly Sample[]): number {
  return Math.min(...samples.map(({ wall }) => wall));
}
