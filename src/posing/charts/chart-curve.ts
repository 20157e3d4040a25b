import type { Quaternion } from '../../core/motion/clip-parts.ts';
import { type ChartValues, isSingular, type RotationChart } from './chart.ts';

/** The rotations of a joint over time. */
export interface RotationMotion {
  /** In seconds, increasing. */
  readonly times: readonly number[];
  /** Unit quaternions xyzw, one for each time. */
  readonly rotations: readonly Quaternion[];
}

/** A motion as it looks in a chart. */
export interface ChartCurve {
  readonly chart: RotationChart;
  /** In seconds. */
  readonly times: readonly number[];
  /** For each time, the numbers that are nearest to those of the time before: nothing wraps. */
  readonly values: readonly ChartValues[];
  /** The times between which the chart is singular, in seconds. */
  readonly singular: readonly (readonly [from: number, to: number])[];
}

/**
 * Draws a motion into a chart.
 *
 * @param stored the numbers at all times, if the motion is stored in them
 */
export function chartCurve(
  chart: RotationChart,
  { times, rotations }: RotationMotion,
  stored?: readonly ChartValues[],
): ChartCurve {
  const values = stored ?? unwrapped(chart, rotations);
  return { chart, times, values, singular: singularTimes(chart, times, values) };
}

/** The numbers of a rotation at a time that may lie between those of the curve. */
export function valuesAt(
  { chart, times, values }: ChartCurve,
  time: number,
  rotation: Quaternion,
): ChartValues {
  const after = times.findIndex((each) => each > time);
  const at = after < 0 ? times.length - 1 : Math.max(0, after - 1);
  return chart.read(rotation, values[at]!);
}

function unwrapped(chart: RotationChart, rotations: readonly Quaternion[]): ChartValues[] {
  let near: ChartValues = [0, 0, 0];
  return rotations.map((rotation) => (near = chart.read(rotation, near)));
}

/** Each singular time stands for the time halfway to those before and after it. */
function singularTimes(
  chart: RotationChart,
  times: readonly number[],
  values: readonly ChartValues[],
): (readonly [number, number])[] {
  const halfway = (i: number): number =>
    (times[Math.max(0, i)]! + times[Math.min(i + 1, times.length - 1)]!) / 2;
  const isIn = values.map((each) => isSingular(chart, each));
  return isIn.flatMap((now, i) => {
    if (!now || isIn[i - 1]) return [];
    const after = isIn.indexOf(false, i);
    const last = (after < 0 ? isIn.length : after) - 1;
    return [[i === 0 ? times[0]! : halfway(i - 1), halfway(last)] as const];
  });
}
