import type { ChartId, RotationChart } from '../../posing/charts/chart.ts';
import type { ChartCurve } from '../../posing/charts/chart-curve.ts';
import type { RotationForm } from '../../core/motion/convert-rotation.ts';
import { formatDegrees } from '../angle-text.ts';
import type { Subject } from './subject.ts';

/** A number of a chart, as it is shown. */
interface ShownNumber {
  readonly name: string;
  /** Its place among the chart's numbers. */
  readonly index: number;
  /** The class with its color and dash. */
  readonly look: string;
}

/** The numbers of a chart in the order in which they are shown; X, Y and Z look so everywhere. */
export function numbersOf({ names }: RotationChart): readonly ShownNumber[] {
  const numbers = names.map((name, index) => {
    const axis = 'XYZ'.indexOf(name);
    return { name, index, look: `number-${(axis < 0 ? index : axis) + 1}` };
  });
  return numbers.sort((a, b) => a.look.localeCompare(b.look));
}

/**
 * Whether a chart is the one in which a motion is stored. A unit quaternion is the rotation vector's
 * direction, with sine and cosine of half its length, so that chart stands for it.
 */
export function isStoredIn(chart: ChartId, stored: RotationForm): boolean {
  return chart === (stored === 'euler' ? 'euler' : 'rotation-vector');
}

export function storedTag(stored: RotationForm): string {
  return stored === 'euler' ? 'stored' : `stored, as quaternions by ${stored}`;
}

/** What a chart's picture shows, for those who can't see it. */
export function chartText(
  { name, clip, motion }: Subject,
  { chart, values, singular }: ChartCurve,
): string {
  const ranges = numbersOf(chart).map(({ name: each, index }) => {
    const own = values.map((value) => value[index]!);
    const low = own.reduce((least, value) => Math.min(least, value), Infinity);
    const high = own.reduce((most, value) => Math.max(most, value), -Infinity);
    return `${each} from ${formatDegrees(low)} to ${formatDegrees(high)}`;
  });
  const places = singular.map(([from, to]) => `${from.toFixed(2)} to ${to.toFixed(2)} s`);
  const tag = isStoredIn(chart.id, motion.stored) ? ` (${storedTag(motion.stored)})` : '';
  return [
    `${chart.label}${tag} of ${name}, ${clip.start.toFixed(2)} to ${clip.end.toFixed(2)} s: ${ranges.join(', ')}`,
    ...(places.length > 0 ? [`singular at ${places.join(', ')}`] : []),
  ].join('; ');
}
