import { type Bounds, diagonal } from '../../core/bounds.ts';

/** A smaller difference, as a part of the character's size, is rounding. */
export const leastPart = 1e-6;

/** How far the points of two posed meshes are from each other. */
export interface Difference {
  /** (pointCount) in model units. */
  readonly distances: Float32Array;
  readonly largest: number;
  /** The point where it is largest. */
  readonly worst: number;
  /** Over all points. */
  readonly mean: number;
}

/** The lengths of a character that differences are parts of, in model units. */
export interface CharacterSize {
  /** The height at rest, or the diagonal if the character is flat. */
  readonly height: number;
  /** Of the bounding box at rest. */
  readonly diagonal: number;
}

export function sizeOf({ bounds }: { readonly bounds: Bounds }): CharacterSize {
  const whole = diagonal(bounds);
  return { height: bounds.max[1]! - bounds.min[1]! || whole, diagonal: whole };
}

/**
 * Computes the distance of each point to the same point of another posed mesh.
 *
 * @param positions (at least pointCount × 3), whose first triples are the points
 * @param base the same, of the other mesh
 * @param least a distance of at most this is rounding and counts as 0
 * @param distances (pointCount) written and returned
 */
export function differenceOf(
  positions: Float32Array,
  base: Float32Array,
  pointCount: number,
  least = 0,
  distances: Float32Array = new Float32Array(pointCount),
): Difference {
  let [largest, worst, sum] = [0, 0, 0];
  for (let point = 0; point < pointCount; point++) {
    let squared = 0;
    for (let i = point * 3; i < point * 3 + 3; i++) squared += (positions[i]! - base[i]!) ** 2;
    const length = Math.sqrt(squared);
    const distance = length > least ? length : 0;
    distances[point] = distance;
    sum += distance;
    if (distance > largest) [largest, worst] = [distance, point];
  }
  return { distances, largest, worst, mean: pointCount > 0 ? sum / pointCount : 0 };
}
