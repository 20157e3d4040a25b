import type { ChartCurve } from '../../posing/charts/chart-curve.ts';

/** The size of a chart's picture; its width fits the inspector. */
export const plotSize = { width: 300, height: 116 };
/** Where the axes are in it. */
const area = { left: 40, right: 294, top: 8, bottom: 96 };
/** A curve that hardly moves is drawn on a scale of at least so many radians. */
const leastRange = Math.PI / 6;
/** The distances of the lines across, in degrees, of which the first that leaves few is taken. */
const steps = [10, 15, 30, 45, 90, 180, 360, 720, 1440, 3600, 7200, 36000];
const mostLines = 5;

/** Where times and angles stand in the plot of a chart. */
interface ChartPlot {
  readonly area: typeof area;
  /** The place of a time in seconds. */
  readonly across: (time: number) => number;
  /** The place of an angle in radians. */
  readonly down: (angle: number) => number;
  /** The angles of the lines across, in degrees. */
  readonly lines: readonly number[];
  /** For each number of the chart, the points of its line, as SVG has them. */
  readonly points: readonly string[];
}

/** @param range the times at the left and at the right edge, in seconds */
export function plotOf({ times, values }: ChartCurve, range: readonly [number, number]): ChartPlot {
  const all = values.flat();
  const low = all.reduce((least, value) => Math.min(least, value), 0);
  const high = all.reduce((most, value) => Math.max(most, value), 0);
  const missing = Math.max(0, leastRange - (high - low)) / 2;
  const [bottom, top] = [low - missing, high + missing];
  const [start, end] = range;
  const across = (time: number): number =>
    area.left + ((time - start) / (end - start || 1)) * (area.right - area.left);
  const down = (angle: number): number =>
    area.bottom - ((angle - bottom) / (top - bottom)) * (area.bottom - area.top);
  const points = (values[0] ?? []).map((_, i) =>
    times.map((time, at) => `${rounded(across(time))},${rounded(down(values[at]![i]!))}`).join(' '),
  );
  return { area, across, down, lines: linesWithin(degrees(bottom), degrees(top)), points };
}

function linesWithin(low: number, high: number): number[] {
  const step = steps.find((each) => (high - low) / each <= mostLines) ?? steps.at(-1)!;
  const first = Math.ceil(low / step);
  const count = Math.floor(high / step) - first + 1;
  return Array.from({ length: count }, (_, i) => (first + i) * step);
}

function degrees(radians: number): number {
  return (radians * 180) / Math.PI;
}

function rounded(place: number): number {
  return Math.round(place * 100) / 100;
}
