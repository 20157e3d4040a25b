import type { MoviePlan } from '../../view/movie/movie-plan.ts';

/** The shortest time of a frame that programs keep to, in hundredths of a second. */
const shortest = 2;
const mostRate = 100 / shortest;

/** The reason why a GIF can't show such a movie, or null. */
export function whyNoGif({ rate }: Pick<MoviePlan, 'rate'>): string | null {
  return rate > mostRate ? `GIF shows at most ${mostRate} frames a second` : null;
}

/**
 * How long a frame is shown, in hundredths of a second, the unit of GIF. Frames begin at the nearest
 * hundredth to their own time, so that no error adds up.
 */
export function gifDelay(frame: number, rate: number): number {
  const at = (index: number): number => Math.round((index * 100) / rate);
  return at(frame + 1) - at(frame);
}
