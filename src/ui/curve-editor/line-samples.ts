import type { PlotLine } from './plot-lines.ts';
import { type Place, type Plot, plottedOf, timeAt, xOf, yOf } from './plot.ts';

/** A part of a line as points, and whether it lies beyond the line's keys. */
export interface SampledRun {
  readonly isBeyond: boolean;
  readonly points: readonly Place[];
}

/**
 * Samples a line at most once for each column of pixels: before its keys, among them and after
 * them. The runs meet at the first and the last key.
 */
export function sampleLine(line: PlotLine, plot: Plot): readonly SampledRun[] {
  const { times } = line;
  if (times.length === 0) return [];
  const [first, last] = [xOf(plot, times[0]!), xOf(plot, times.at(-1)!)];
  const { width } = plot;
  const inside = (x: number): number => Math.min(Math.max(x, 0), width);
  const runs = [
    { isBeyond: true, from: 0, to: inside(first), isSeen: first > 0 },
    { isBeyond: false, from: inside(first), to: inside(last), isSeen: last >= 0 && first <= width },
    { isBeyond: true, from: inside(last), to: width, isSeen: last < width },
  ];
  return runs
    .filter(({ isSeen, from, to }) => isSeen && to > from)
    .map(({ isBeyond, from, to }) => ({ isBeyond, points: pointsBetween(line, plot, from, to) }));
}

function pointsBetween(line: PlotLine, plot: Plot, from: number, to: number): Place[] {
  const at = (x: number): Place => ({ x, y: yAtX(line, plot, x) });
  const points = [at(from)];
  for (let x = Math.floor(from) + 1; x < to; x++) points.push(at(x));
  points.push(at(to));
  return points;
}

export function yAtX({ scale, valueAt }: PlotLine, plot: Plot, x: number): number {
  return yOf(plot, plottedOf(scale, valueAt(timeAt(plot, x))));
}

/** Where a key of a line stands. */
export function keyPlace({ times, values, scale }: PlotLine, key: number, plot: Plot): Place {
  return { x: xOf(plot, times[key]!), y: yOf(plot, plottedOf(scale, values[key]!)) };
}
