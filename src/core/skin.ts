/** A palette entry that follows no joint but stands still in the character's space. */
export const noJoint = 0xffff;

/** How normals follow: with the matrix that the vertex follows, or each joint turning them on its own. */
export type NormalsId = 'blended' | 'joints';

/**
 * Which joints move which point, and how much: compressed sparse rows of *palette entries*. An
 * entry is a joint with its inverse bind matrix. Rows have as many influences as the file gives.
 */
export interface Skin {
  /** (entryCount) joint of each palette entry, or `noJoint`. */
  readonly paletteJoint: Uint16Array;
  /** (entryCount × 16) column-major, float64: character space at bind → joint frame. */
  readonly jointFromBind: Float64Array;
  /** (entryCount × 16) its inverses as the file has them, where it has these: for writers. */
  readonly bindFromJoint?: Float64Array;
  /** (pointCount + 1) where each point's influences start. */
  readonly start: Uint32Array;
  /** (start[pointCount]) palette entry of each influence. */
  readonly entries: Uint16Array;
  /** (start[pointCount]) as the file has them: the courses' formula does not renormalise. */
  readonly weights: Float32Array;
  /** How the programs of the file's own format turn normals. */
  readonly normals: NormalsId;
}

export function largestInfluenceCount(skin: Skin): number {
  let largest = 0;
  for (let point = 0; point + 1 < skin.start.length; point++) {
    largest = Math.max(largest, skin.start[point + 1]! - skin.start[point]!);
  }
  return largest;
}

/**
 * The same skin with each row divided by its sum; rows that sum to nearly nothing, measured by their
 * own weights, stay as they are.
 */
export function normalizeSkin(skin: Skin): Skin {
  const weights = skin.weights.slice();
  for (let point = 0; point + 1 < skin.start.length; point++) {
    const from = skin.start[point]!;
    const to = skin.start[point + 1]!;
    let sum = 0;
    let size = 0;
    for (let i = from; i < to; i++) {
      sum += skin.weights[i]!;
      size += Math.abs(skin.weights[i]!);
    }
    if (!(Math.abs(sum) > size * 1e-3)) continue;
    for (let i = from; i < to; i++) weights[i] = skin.weights[i]! / sum;
  }
  return { ...skin, weights };
}
