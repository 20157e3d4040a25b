import { influencesOf, type Skin } from '../../core/skin.ts';
import type { Vector3 } from '../../posing/ik/problem.ts';
import { writeAffineRows } from '../../skinning/affine-palette.ts';
import type { Evaluation } from '../evaluation.ts';
import type { Ghost } from './explanation.ts';

/** The names of the columns of a place or an offset. */
export const axes: readonly string[] = ['x', 'y', 'z'];

/** A point of a mesh; the vertices of points come first, so that they have the same index. */
export function pointOf(positions: ArrayLike<number>, point: number): Vector3 {
  return [positions[point * 3]!, positions[point * 3 + 1]!, positions[point * 3 + 2]!];
}

/** The upper three rows of an entry's `T · B⁻¹`, 12 numbers row by row, in float64. */
export function motionOf({ skin, characterFromJoint }: Evaluation, entry: number): Float64Array {
  const rows = new Float64Array(12);
  writeAffineRows(skin, characterFromJoint, entry, rows, 0);
  return rows;
}

/** Applies a 3 × 4 matrix, row by row. */
export function applyRows(rows: ArrayLike<number>, [x, y, z]: Vector3): Vector3 {
  const at = (i: number): number =>
    rows[i]! * x + rows[i + 1]! * y + rows[i + 2]! * z + rows[i + 3]!;
  return [at(0), at(4), at(8)];
}

/**
 * Where each joint that influences a point would take a place at rest alone, in the skin's order.
 *
 * @param skin has the weights as the method uses them
 */
export function ghostsOf(
  evaluation: Evaluation,
  point: number,
  skin: Skin = evaluation.skin,
  place: Vector3 = pointOf(evaluation.rest.positions, point),
): readonly Ghost[] {
  return influencesOf(skin, point).map(({ entry, weight }) => ({
    ...{ entry, weight },
    place: applyRows(motionOf(evaluation, entry), place),
  }));
}

/** `Σ w T B⁻¹ p` */
export function blendOf(ghosts: readonly Ghost[]): Vector3 {
  return sumOfVectors(ghosts.map(({ weight, place }) => scaled(place, weight)));
}

export function scaled([x, y, z]: Vector3, by: number): Vector3 {
  return [x * by, y * by, z * by];
}

export function sumOfVectors(vectors: readonly Vector3[]): Vector3 {
  return vectors.reduce<Vector3>(
    ([ax, ay, az], [bx, by, bz]) => [ax + bx, ay + by, az + bz],
    [0, 0, 0],
  );
}
