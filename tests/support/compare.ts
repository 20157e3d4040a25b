import type { Matrix } from '../reference/matrix.ts';

/**
 * The largest |a − b|. It is infinite if lengths differ or a value is NaN, so that neither goes
 * unnoticed.
 */
export function largestDifference(a: ArrayLike<number>, b: ArrayLike<number>): number {
  if (a.length !== b.length) return Infinity;
  let largest = 0;
  for (let i = 0; i < a.length; i++) {
    const difference = Math.abs(a[i]! - b[i]!);
    if (Number.isNaN(difference)) return Infinity;
    largest = Math.max(largest, difference);
  }
  return largest;
}

export function boundingDiagonal(points: readonly (readonly number[])[]): number {
  const sizes = [0, 1, 2].map((axis) => {
    const values = points.map((point) => point[axis]!);
    return Math.max(...values) - Math.min(...values);
  });
  return Math.hypot(...sizes);
}

/** Converts a matrix of the oracle to 16 numbers, column by column. */
export function columnMajor(matrix: Matrix): number[] {
  return [0, 1, 2, 3].flatMap((column) => matrix.map((row) => row[column]!));
}

export function numbersAt(values: ArrayLike<number>, index: number, size: number): number[] {
  return Array.from({ length: size }, (_, i) => values[index * size + i]!);
}
