import type { Quaternion } from '../../core/motion/clip-parts.ts';

export type ChartId = 'euler' | 'swing-twist' | 'rotation-vector';

/** Three numbers, in radians, of a rotation in a chart; a joint with fewer hinges has fewer. */
export type ChartValues = readonly number[];

/**
 * A way to write the rotations of one joint as numbers. No chart of three numbers covers all
 * rotations evenly: each has places where a small turn changes its numbers by any amount.
 */
export interface RotationChart {
  readonly id: ChartId;
  readonly label: string;
  /** The names of its numbers. */
  readonly names: readonly string[];
  /**
   * The numbers of a rotation. Of all that give the same rotation, those nearest to `near`.
   *
   * @param rotation unit quaternion xyzw: the product of the joint's own turns
   */
  read(rotation: Quaternion, near: ChartValues): ChartValues;
  /** The rotation of numbers, a unit quaternion xyzw. */
  rotationOf(values: ChartValues): Quaternion;
  /**
   * The most by which a small turn of the joint can change one of the numbers, in radians per
   * radian; at least 1, and Infinity where the chart folds.
   */
  stretchAt(values: ChartValues): number;
  /** What folds at such numbers, in one sentence. */
  foldText(values: ChartValues): string;
}

/**
 * The stretch from which on a place counts as singular: that of Euler angles at 5° from gimbal lock,
 * as in `gimbalLock`.
 */
const mostStretch = 1 / Math.sin((5 * Math.PI) / 180);

export function isSingular(chart: RotationChart, values: ChartValues): boolean {
  return chart.stretchAt(values) >= mostStretch;
}
