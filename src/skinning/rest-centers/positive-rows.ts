import { influencesOf, type Skin } from '../../core/skin.ts';
import { positiveSkin } from '../positive-skin.ts';

/** The weights of one place by palette entries; no weight is zero or negative. */
export interface PositiveRow {
  /** (n) ascending */
  readonly entries: readonly number[];
  /** (n) */
  readonly weights: readonly number[];
}

/** The positive weights of every point. Influences of one palette entry are added. */
export function positiveRows(skin: Skin): PositiveRow[] {
  const positive = positiveSkin(skin);
  return Array.from({ length: skin.start.length - 1 }, (_, point) =>
    rowOf(
      influencesOf(positive, point)
        .filter(({ weight }) => weight > 0)
        .map(({ entry, weight }) => [entry, weight]),
    ),
  );
}

/** The mean of three rows. */
export function meanRow(a: PositiveRow, b: PositiveRow, c: PositiveRow): PositiveRow {
  return rowOf(
    [a, b, c].flatMap(({ entries, weights }) =>
      entries.map((entry, i) => [entry, weights[i]! / 3] as const),
    ),
  );
}

function rowOf(influences: readonly (readonly [entry: number, weight: number])[]): PositiveRow {
  const sums = new Map<number, number>();
  for (const [entry, weight] of influences) sums.set(entry, (sums.get(entry) ?? 0) + weight);
  const entries = [...sums.keys()].sort((a, b) => a - b);
  return { entries, weights: entries.map((entry) => sums.get(entry)!) };
}
