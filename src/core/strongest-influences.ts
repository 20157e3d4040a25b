import { type Skin, skinWithRows } from './skin.ts';

/** A palette entry, and how much it influences a point. */
export interface Influence {
  readonly entry: number;
  readonly weight: number;
}

/**
 * Returns the `most` weights of a row that are largest without their signs, scaled to the sum of
 * the whole row; of equal ones the earlier. They are not scaled if they cancel each other.
 */
export function strongestInfluences(row: readonly Influence[], most: number): readonly Influence[] {
  if (row.length <= most) return row;
  const kept = byStrength(row).slice(0, most);
  const sum = sumOf(kept);
  const scale = Math.abs(sum) > kept.length * 1e-6 ? sumOf(row) / sum : 1;
  return kept.map(({ entry, weight }) => ({ entry, weight: weight * scale }));
}

/** The influences of a point, in the file's order. */
export function influencesOf({ start, entries, weights }: Skin, point: number): Influence[] {
  const row: Influence[] = [];
  for (let i = start[point]!; i < start[point + 1]!; i++) {
    row.push({ entry: entries[i]!, weight: weights[i]! });
  }
  return row;
}

/**
 * Returns the same skin with only the `most` strongest influences of each point, as
 * `strongestInfluences` keeps and scales them.
 */
export function keepInfluences(skin: Skin, most: number): Skin {
  const points: number[] = [];
  const start = [0];
  const kept: Influence[] = [];
  for (let point = 0; point + 1 < skin.start.length; point++) {
    if (skin.start[point + 1]! - skin.start[point]! <= most) continue;
    points.push(point);
    kept.push(...strongestInfluences(influencesOf(skin, point), most));
    start.push(kept.length);
  }
  const entries = kept.map(({ entry }) => entry);
  const weights = kept.map(({ weight }) => weight);
  return skinWithRows(skin, points, { start, entries, weights });
}

/** Orders influences by the size of their weights, the largest first. */
export function byStrength(row: readonly Influence[]): Influence[] {
  return row.toSorted((a, b) => Math.abs(b.weight) - Math.abs(a.weight));
}

function sumOf(row: readonly Influence[]): number {
  return row.reduce((sum, { weight }) => sum + weight, 0);
}
