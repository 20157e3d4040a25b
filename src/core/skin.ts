import type { FaceWeighting } from './vertex-normals.ts';

/** A palette entry that follows no joint and never moves in the character's space. */
export const noJoint = 0xffff;

/** How normals are transformed: by the vertex's blended matrix, or by each joint on its own. */
export type SkinnedNormalsId = 'blended' | 'joints';

/** How normals follow: transformed with the skin, or recomputed from the posed faces. */
export type NormalsId = SkinnedNormalsId | FaceWeighting;

/**
 * Which joints influence which point, and how much, in compressed sparse rows of *palette entries*.
 * An entry is a joint with its inverse bind matrix. Rows have as many influences as the file gives.
 */
export interface Skin {
  /** (entryCount) joint of each palette entry, or `noJoint`. */
  readonly paletteJoint: Uint16Array;
  /**
   * (entryCount × 16) column-major, float64: from the character's space at bind time to the joint's
   * frame.
   */
  readonly jointFromBind: Float64Array;
  /** (entryCount × 16) the inverses of `jointFromBind`, if the file stores these; for writers. */
  readonly bindFromJoint?: Float64Array;
  /** (pointCount + 1) where each point's influences start. */
  readonly start: Uint32Array;
  /** (start[pointCount]) palette entry of each influence. */
  readonly entries: Uint16Array;
  /** (start[pointCount]) as the file has them; the courses' formula does not normalize them. */
  readonly weights: Float32Array;
  /** How the format's own programs transform normals. */
  readonly normals: SkinnedNormalsId;
}

export function largestInfluenceCount(skin: Skin): number {
  let largest = 0;
  for (let point = 0; point + 1 < skin.start.length; point++) {
    largest = Math.max(largest, skin.start[point + 1]! - skin.start[point]!);
  }
  return largest;
}

/** Influences of some points, packed like those of a skin. */
export interface InfluenceRows {
  /** (n + 1) where each row starts. */
  readonly start: ArrayLike<number>;
  readonly entries: ArrayLike<number>;
  readonly weights: ArrayLike<number>;
}

/**
 * Returns the same skin with other rows at some points. It shares all unchanged arrays with the
 * given skin, including `start` if no row changes its length, so that the two can be compared row
 * by row.
 *
 * @param points (n) increasing
 */
export function skinWithRows(skin: Skin, points: ArrayLike<number>, rows: InfluenceRows): Skin {
  const lengths = Uint32Array.from({ length: skin.start.length - 1 }, (_, p) => rowLength(skin, p));
  for (let row = 0; row < points.length; row++) lengths[points[row]!] = rowLength(rows, row);
  const start = startsOf(lengths);
  const stays = start.every((at, point) => at === skin.start[point]);
  const entries = new Uint16Array(start.at(-1)!);
  const weights = new Float32Array(start.at(-1)!);
  for (let point = 0, row = 0; point < lengths.length; point++) {
    const isOther = points[row] === point;
    const source = isOther ? rows : skin;
    const from = source.start[isOther ? row++ : point]!;
    for (let i = 0; i < lengths[point]!; i++) {
      entries[start[point]! + i] = source.entries[from + i]!;
      weights[start[point]! + i] = source.weights[from + i]!;
    }
  }
  const sameEntries = stays && entries.every((entry, i) => entry === skin.entries[i]);
  return {
    ...skin,
    start: stays ? skin.start : start,
    entries: sameEntries ? skin.entries : entries,
    weights,
  };
}

/** A palette entry, and how much it influences a point. */
export interface Influence {
  readonly entry: number;
  readonly weight: number;
}

/** The influences of a point, in the file's order. */
export function influencesOf({ start, entries, weights }: Skin, point: number): Influence[] {
  const row: Influence[] = [];
  for (let i = start[point]!; i < start[point + 1]!; i++) {
    row.push({ entry: entries[i]!, weight: weights[i]! });
  }
  return row;
}

export function sumOf(row: readonly Influence[]): number {
  return row.reduce((sum, { weight }) => sum + weight, 0);
}

/** @param change returns another row for a point, or the same one */
export function mapRows(
  skin: Skin,
  change: (row: readonly Influence[]) => readonly Influence[],
): Skin {
  const points: number[] = [];
  const start = [0];
  const changed: Influence[] = [];
  for (let point = 0; point + 1 < skin.start.length; point++) {
    const row = influencesOf(skin, point);
    const next = change(row);
    if (next === row) continue;
    points.push(point);
    changed.push(...next);
    start.push(changed.length);
  }
  const entries = changed.map(({ entry }) => entry);
  return skinWithRows(skin, points, {
    start,
    entries,
    weights: changed.map((each) => each.weight),
  });
}

/**
 * Returns the same skin with each row divided by its sum. Rows whose sum is nearly zero, relative
 * to the magnitudes of their weights, do not change.
 */
export function normalizeSkin(skin: Skin): Skin {
  return mapRows(skin, (row) => {
    const sum = sumOf(row);
    const size = row.reduce((total, { weight }) => total + Math.abs(weight), 0);
    if (sum === 1 || !(Math.abs(sum) > size * 1e-3)) return row;
    return row.map(({ entry, weight }) => ({ entry, weight: weight / sum }));
  });
}

function rowLength({ start }: { readonly start: ArrayLike<number> }, row: number): number {
  return start[row + 1]! - start[row]!;
}

function startsOf(lengths: Uint32Array): Uint32Array {
  const start = new Uint32Array(lengths.length + 1);
  lengths.forEach((length, row) => (start[row + 1] = start[row]! + length));
  return start;
}
