import { type Influence, mapRows, type Skin, sumOf } from './skin.ts';

/**
 * Returns the `most` weights of a row that are largest without their signs, scaled to the sum of
 * the whole row; of equal ones the earlier. They are not scaled if they cancel each other.
 */
export function strongestInfluences(row: readonly Influence[], most: number): readonly Influence[] {
  if (row.length <= most) return row;
  const kept = byStrength(row).slice(0, most);
  const sum = sumOf(kept);
  const scale = Math.abs(sum) > 1e-6 ? sumOf(row) / sum : 1;
  return kept.map(({ entry, weight }) => ({ entry, weight: weight * scale }));
}

/**
 * Returns the same skin with only the `most` strongest influences of each point, as
 * `strongestInfluences` keeps and scales them.
 */
export function keepInfluences(skin: Skin, most: number): Skin {
  return mapRows(skin, (row) => strongestInfluences(row, most));
}

/** Orders influences by the size of their weights, the largest first. */
export function byStrength(row: readonly Influence[]): Influence[] {
  return row.toSorted((a, b) => Math.abs(b.weight) - Math.abs(a.weight));
}
