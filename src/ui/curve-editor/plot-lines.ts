import { channelFor, evaluateChannel, isStepped } from '../../core/motion/channel.ts';
import { type Extrapolation, isRotationChannel } from '../../core/motion/clip-parts.ts';
import type { ChannelKey } from '../../core/motion/targets.ts';
import { type CurveScale, normalizing, ownScale } from './plot.ts';
import { rotationCurvesOf, rotationPartAt } from './rotation-curves.ts';
import { scalarOf, type ShownCurve } from './shown-curves.ts';

/** A line of the plot: the curve of a number, or one part of a rotation. */
export interface PlotLine {
  readonly key: ChannelKey;
  readonly color: string;
  readonly isDotted: boolean;
  readonly scale: CurveScale;
  readonly before: Extrapolation;
  readonly after: Extrapolation;
  /** (keyCount) seconds, increasing, and the values there. */
  readonly times: Float64Array;
  readonly values: Float64Array;
  /** (keyCount) value a second; null where the line's keys have no slopes. */
  readonly slopes: LineSlopes | null;
  readonly valueAt: (time: number) => number;
}

interface LineSlopes {
  readonly before: Float64Array;
  readonly after: Float64Array;
  /** Whether a key's slope has an effect on its side; a stepped span has none. */
  readonly actsBefore: (key: number) => boolean;
  readonly actsAfter: (key: number) => boolean;
}

type Line = Omit<PlotLine, 'scale'>;

/** @param isNormalized whether each line fills the same height */
export function plotLines(curves: readonly ShownCurve[], isNormalized: boolean): PlotLine[] {
  return curves.flatMap((curve) => {
    const lines = linesOf(curve);
    const range = rangeOf(lines);
    const scale = isNormalized && range ? normalizing(range) : ownScale;
    return lines.map((line) => ({ ...line, scale }));
  });
}

function linesOf(shown: ShownCurve): readonly Line[] {
  const { key, color, isDotted, channel } = shown;
  const { before, after } = channel;
  const shared = { key, before, after };
  const scalar = scalarOf(shown);
  if (scalar) {
    const compiled = channelFor(scalar);
    const { times, values, slopesIn, slopesOut } = compiled;
    const last = times.length - 1;
    const { keys } = scalar;
    const slopes: LineSlopes = {
      before: slopesIn,
      after: slopesOut,
      actsBefore: (at) => (at === 0 ? before === 'linear' && last > 0 : !isStepped(keys, at - 1)),
      actsAfter: (at) => (at === last ? after === 'linear' && last > 0 : !isStepped(keys, at)),
    };
    const valueAt = (time: number): number => evaluateChannel(compiled, time);
    return [{ ...shared, color, isDotted, times, values, slopes, valueAt }];
  }
  if (!isRotationChannel(channel)) return [];
  const sampled = rotationCurvesOf(channel);
  const times = Float64Array.from(channel.keys, ({ time }) => time);
  return ([0, 1, 2] as const).map((axis) => {
    const valueAt = (time: number): number => rotationPartAt(sampled, axis, time);
    const values = times.map(valueAt);
    const color = 'xyz'[axis]!;
    return { ...shared, color, isDotted: false, times, values, slopes: null, valueAt };
  });
}

const rangeSamples = 200;

/** The least and the greatest value of lines over their keys; null without keys. */
function rangeOf(lines: readonly Line[]): readonly [number, number] | null {
  let [low, high] = [Infinity, -Infinity];
  for (const { times, values, valueAt } of lines) {
    const [start, end] = [times[0] ?? 0, times.at(-1) ?? 0];
    const take = (value: number): void => {
      low = Math.min(low, value);
      high = Math.max(high, value);
    };
    values.forEach(take);
    if (values.length < 2) continue;
    for (let i = 0; i <= rangeSamples; i++)
      take(valueAt(start + ((end - start) * i) / rangeSamples));
  }
  return low <= high ? [low, high] : null;
}

/** The plotted range of lines over their keys, and their keys' times; null without keys. */
export function boundsOf(lines: readonly PlotLine[]): PlotBounds | null {
  let bounds: PlotBounds | null = null;
  for (const line of lines) {
    const range = rangeOf([line]);
    if (!range) continue;
    const { factor, offset } = line.scale;
    const [low, high] = range.map((value) => value * factor + offset) as [number, number];
    bounds = united(bounds, {
      times: [line.times[0]!, line.times.at(-1)!],
      values: [low, high],
    });
  }
  return bounds;
}

export interface PlotBounds {
  readonly times: readonly [number, number];
  readonly values: readonly [number, number];
}

function united(a: PlotBounds | null, b: PlotBounds): PlotBounds {
  if (!a) return b;
  return {
    times: [Math.min(a.times[0], b.times[0]), Math.max(a.times[1], b.times[1])],
    values: [Math.min(a.values[0], b.values[0]), Math.max(a.values[1], b.values[1])],
  };
}
