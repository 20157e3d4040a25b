import { type TimeWindow, timeAtX, xOfTime } from '../timeline/time-axis.ts';

/** What the plot shows from its bottom to its top, in plotted values. */
export type ValueWindow = readonly [low: number, high: number];

/** The part of the plane of time and value that is seen, and the pixels that it fills. */
export interface Plot {
  readonly time: TimeWindow;
  readonly values: ValueWindow;
  /** In CSS pixels. */
  readonly width: number;
  readonly height: number;
}

/** A place in the plot in pixels, from its upper left corner. */
export interface Place {
  readonly x: number;
  readonly y: number;
}

/**
 * How a curve's values are drawn: value × factor + offset. Curves stand at their own values, or are
 * each stretched to the same height.
 */
export interface CurveScale {
  readonly factor: number;
  readonly offset: number;
}

export const ownScale: CurveScale = { factor: 1, offset: 0 };

export function plottedOf({ factor, offset }: CurveScale, value: number): number {
  return value * factor + offset;
}

export function valueOf({ factor, offset }: CurveScale, plotted: number): number {
  return (plotted - offset) / factor;
}

/** The scale by which a range of values fills -1 to 1; a range of no height is moved to 0. */
export function normalizing([low, high]: readonly [number, number]): CurveScale {
  const factor = high - low > 1e-9 ? 2 / (high - low) : 1;
  return { factor, offset: (-(low + high) / 2) * factor };
}

export function xOf({ time, width }: Plot, seconds: number): number {
  return xOfTime(time, width, seconds);
}

export function timeAt({ time, width }: Plot, x: number): number {
  return timeAtX(time, width, x);
}

export function yOf({ values: [low, high], height }: Plot, plotted: number): number {
  return ((high - plotted) / (high - low)) * height;
}

export function plottedAt({ values: [low, high], height }: Plot, y: number): number {
  return high - (y / height) * (high - low);
}

/** Where a time and a plotted value that are at a place of one plot are in another. */
export function placeIn(other: Plot, plot: Plot, { x, y }: Place): Place {
  return { x: xOf(other, timeAt(plot, x)), y: yOf(other, plottedAt(plot, y)) };
}

/** How many pixels a slope of 1 (plotted value a second) falls in each pixel to the right. */
export function slopePixels({ time, values, width, height }: Plot): number {
  return (-(height / (values[1] - values[0])) * (time[1] - time[0])) / width;
}

/** The least height that can be shown, and the greatest. */
const [lowest, highest] = [1e-6, 1e9];

/** Shows more values if the factor exceeds 1, less otherwise; a plotted value stays where it is. */
export function zoomedValues([low, high]: ValueWindow, about: number, factor: number): ValueWindow {
  const height = Math.min(Math.max((high - low) * factor, lowest), highest);
  const by = height / (high - low);
  return [about + (low - about) * by, about + (high - about) * by];
}

/** The window that shows a range of values with some room above and below. */
export function framingValues([low, high]: ValueWindow): ValueWindow {
  const middle = (low + high) / 2;
  const half = high - low > 1e-6 ? (high - low) * 0.62 : Math.max(Math.abs(middle) * 0.5, 0.5);
  return [middle - half, middle + half];
}
