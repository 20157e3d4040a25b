import type { Extrapolation } from './clip-parts.ts';

/**
 * The span between two keys in which a time is: the last one that starts at the time or before it.
 *
 * @param times (keyCount ≥ 2) seconds, increasing
 * @param time between the first and the last of them
 */
export function spanAt(times: Float64Array, time: number): number {
  let span = 0;
  let above = times.length - 1;
  while (above - span > 1) {
    const middle = (span + above) >> 1;
    if (times[middle]! <= time) span = middle;
    else above = middle;
  }
  return span;
}

/** In which repetition of the keys a time is: 0 is their own range, before it they are negative. */
export function cycleAt(times: Float64Array, time: number): number {
  return Math.floor((time - times[0]!) / (times[times.length - 1]! - times[0]!));
}

/** The time between the first and the last key that a time of a repetition stands for. */
export function timeInCycle(
  times: Float64Array,
  rule: Extrapolation,
  time: number,
  cycle: number,
): number {
  const start = times[0]!;
  const end = times[times.length - 1]!;
  const into = Math.min(Math.max(time - start - cycle * (end - start), 0), end - start);
  return rule === 'bounce' && cycle % 2 !== 0 ? end - into : start + into;
}
