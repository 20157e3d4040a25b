import type { Skin } from '../core/skin.ts';

/** A palette entry, and how much it influences a point. */
export interface Influence {
  readonly entry: number;
  readonly weight: number;
}

/** Returns the largest `most` weights of a row, scaled to the sum of the whole row. */
export function strongestInfluences(row: readonly Influence[], most: number): readonly Influence[] {
  if (row.length <= most) return row;
  const kept = byWeight(row).slice(0, most);
  const sum = sumOf(kept);
  const scale = sum > 0 ? sumOf(row) / sum : 1;
  return kept.map(({ entry, weight }) => ({ entry, weight: weight * scale }));
}

/** The influences of a point. */
export function influencesOf({ start, entries, weights }: Skin, point: number): Influence[] {
  const row: Influence[] = [];
  for (let i = start[point]!; i < start[point + 1]!; i++) {
    row.push({ entry: entries[i]!, weight: weights[i]! });
  }
  return row;
}

/** What is lost of a skin if each point keeps only its `most` largest weights. */
export interface InfluencesLost {
  readonly pointCount: number;
  /** The largest part of a point's weights, from 0 to 1. */
  readonly largestShare: number;
}

export function influencesLost(skin: Skin, most: number): InfluencesLost {
  let pointCount = 0;
  let largestShare = 0;
  for (let point = 0; point + 1 < skin.start.length; point++) {
    if (skin.start[point + 1]! - skin.start[point]! <= most) continue;
    const sizes = byWeight(influencesOf(skin, point)).map(({ weight }) => Math.abs(weight));
    const sumOfSizes = (from: number): number => {
      return sizes.slice(from).reduce((sum, size) => sum + size, 0);
    };
    pointCount++;
    largestShare = Math.max(largestShare, sumOfSizes(most) / sumOfSizes(0));
  }
  return { pointCount, largestShare };
}

function byWeight(row: readonly Influence[]): Influence[] {
  return row.toSorted((a, b) => b.weight - a.weight);
}

function sumOf(row: readonly Influence[]): number {
  return row.reduce((sum, { weight }) => sum + weight, 0);
}
