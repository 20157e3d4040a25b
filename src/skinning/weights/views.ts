import { noJoint, type Skin } from '../../core/skin.ts';
import type { JointColors } from './joint-colors.ts';
import {
  belowColor,
  type Bytes,
  colorAt,
  countColors,
  errorRamp,
  excessRamp,
  hueRamp,
  shortRamp,
  zeroColor,
} from './ramps.ts';

export type WeightViewId = 'joints' | 'joint' | 'count' | 'sum' | 'error';

/** What the colors of a skin are made from. */
export interface WeightSubject {
  /** The weights in use. */
  readonly skin: Skin;
  readonly colors: JointColors;
  /** The joint whose weights are shown alone, or null. */
  readonly joint: number | null;
  /** (pointCount) how far each point is from where all influences put it; null if all are kept. */
  readonly errors: Float32Array | null;
  /** The largest of these. */
  readonly largestError: number;
}

/** The color of each point. */
type PointColor = (point: number) => Bytes;

/** A way to show weights in color. To add one, add a row to `weightViews`. */
interface WeightView {
  readonly id: WeightViewId;
  readonly label: string;
  colorOf(subject: WeightSubject): PointColor;
}

export const weightViews: readonly WeightView[] = [
  { id: 'joints', label: 'All joints', colorOf: meanColor },
  { id: 'joint', label: 'One joint', colorOf: jointColor },
  { id: 'count', label: 'Number of influences', colorOf: countColor },
  { id: 'sum', label: 'Error of the sum', colorOf: sumColor },
  { id: 'error', label: 'Error of keeping few', colorOf: errorColor },
];

/**
 * (vertexCount × 4) the color of each render vertex: sRGB bytes, and 255.
 *
 * @param pointOf (vertexCount)
 */
export function vertexColors(
  id: WeightViewId,
  subject: WeightSubject,
  pointOf: Uint32Array,
): Uint8Array {
  const colorOf = weightViews.find((view) => view.id === id)!.colorOf(subject);
  const bytes = new Uint8Array(pointOf.length * 4).fill(255);
  pointOf.forEach((point, vertex) => {
    // The first render vertices are the points themselves.
    if (point < vertex) bytes.copyWithin(vertex * 4, point * 4, point * 4 + 3);
    else bytes.set(colorOf(point), vertex * 4);
  });
  return bytes;
}

/** The smallest and largest exponent of ten of the errors of sums that have colors. */
export const [leastExponent, largestExponent] = [-6, 0] as const;

/** The sum of a point's weights, in float64. */
export function rowSum({ start, weights }: Skin, point: number): number {
  let sum = 0;
  for (let i = start[point]!; i < start[point + 1]!; i++) sum += weights[i]!;
  return sum;
}

/** The number of a point's weights that are not zero. */
export function rowCount({ start, weights }: Skin, point: number): number {
  let count = 0;
  for (let i = start[point]!; i < start[point + 1]!; i++) if (weights[i] !== 0) count++;
  return count;
}

/** The weight of a joint at a point. */
export function weightOf(
  { start, weights, entries, paletteJoint }: Skin,
  point: number,
  joint: number,
): number {
  let sum = 0;
  for (let i = start[point]!; i < start[point + 1]!; i++) {
    if (paletteJoint[entries[i]!] === joint) sum += weights[i]!;
  }
  return sum;
}

/**
 * The mean of the joints' colors with the weights, of sRGB's encoded values as programs of the
 * course average them, over their sum. Negative weights have no part in it. What follows no joint is
 * gray.
 */
function meanColor({ skin, colors: { bytes } }: WeightSubject): PointColor {
  const { start, entries, weights, paletteJoint } = skin;
  return (point) => {
    let [red, green, blue, sum] = [0, 0, 0, 0];
    for (let i = start[point]!; i < start[point + 1]!; i++) {
      const weight = Math.max(0, weights[i]!);
      const joint = paletteJoint[entries[i]!]!;
      const [r, g, b] =
        joint === noJoint
          ? zeroColor
          : [bytes[joint * 3]!, bytes[joint * 3 + 1]!, bytes[joint * 3 + 2]!];
      red += weight * r;
      green += weight * g;
      blue += weight * b;
      sum += weight;
    }
    if (sum === 0) return zeroColor;
    return [Math.round(red / sum), Math.round(green / sum), Math.round(blue / sum)];
  };
}

function jointColor({ skin, joint, colors }: WeightSubject): PointColor {
  if (joint === null) return () => zeroColor;
  const ramp = hueRamp(colors.hues[joint]!);
  return (point) => {
    const weight = weightOf(skin, point, joint);
    if (weight === 0) return zeroColor;
    return weight < 0 ? belowColor : colorAt(ramp, weight);
  };
}

function countColor({ skin }: WeightSubject): PointColor {
  return (point) => countColors[Math.min(rowCount(skin, point), countColors.length - 1)]!;
}

/** On a scale of powers of ten, since sums are off by rounding or by much more. */
function sumColor({ skin }: WeightSubject): PointColor {
  return (point) => {
    const error = rowSum(skin, point) - 1;
    const exponent = Math.log10(Math.abs(error));
    if (exponent < leastExponent) return zeroColor;
    const part = (exponent - leastExponent) / (largestExponent - leastExponent);
    return colorAt(error < 0 ? shortRamp : excessRamp, part);
  };
}

function errorColor({ errors, largestError }: WeightSubject): PointColor {
  return (point) => {
    const error = errors?.[point] ?? 0;
    return error === 0 ? zeroColor : colorAt(errorRamp, error / largestError);
  };
}
