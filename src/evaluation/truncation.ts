import { skinInUse } from '../document/scene.ts';
import { differenceOf, leastPart, sizeOf } from './comparison/difference.ts';
import type { Evaluation } from './evaluation.ts';
import { poseVertices } from '../skinning/pose-vertices.ts';

/** How far points are, in the pose that is shown, from where all of their influences put them. */
export interface Truncation {
  /** (pointCount) distances in model units; what only rounding moved has 0. */
  readonly errors: Float32Array;
  readonly movedCount: number;
  readonly largest: number;
  /** Over all points. */
  readonly mean: number;
  /** The point that is farthest off. */
  readonly worst: number;
  /** The character's height at rest, or its size if it is flat; model units. */
  readonly height: number;
}

/**
 * Returns the effect of keeping only some influences, or null if all are kept. It is computed on the
 * CPU, from float32 positions, once for each pose; its arrays are overwritten for the next.
 */
export function truncationOf(evaluation: Evaluation): Truncation | null {
  const { state, revisions, rest, method, palette, use } = evaluation;
  const { mesh } = state.character;
  if (state.influences === null || mesh.pointCount === 0) return null;
  let held = truncations.get(evaluation);
  if (held?.revision === revisions.vertices) return held.truncation;
  const full = held?.full ?? new Float32Array(rest.vertexCount * 3);
  const fullSkin = skinInUse({ ...state, influences: null });
  poseVertices(method, mesh, rest, fullSkin, palette, use, { positions: full, normals: null });
  const kept = evaluation.vertices().positions;
  const { height, diagonal } = sizeOf(state.character);
  const least = leastPart * diagonal;
  const written = held?.truncation.errors;
  const difference = differenceOf(kept, full, mesh.pointCount, least, written);
  const { distances: errors, largest, mean, worst } = difference;
  const movedCount = errors.reduce((count, error) => count + Number(error > 0), 0);
  held = {
    revision: revisions.vertices,
    full,
    truncation: { errors, movedCount, largest, mean, worst, height },
  };
  truncations.set(evaluation, held);
  return held.truncation;
}

/** Says what keeping few influences does to the pose; lengths are in model units. */
export function truncationLines(truncation: Truncation): string[] {
  const { errors, movedCount, largest, mean, worst, height } = truncation;
  const count = (number: number): string => number.toLocaleString('en');
  if (movedCount === 0) return ['It moves no vertex in this pose'];
  const length = (distance: number): string =>
    `${rounded(distance, 3)} (${rounded((100 * distance) / height, 2)} % of the height)`;
  return [
    `At most ${length(largest)}, vertex #${worst}`,
    `${count(movedCount)} of ${count(errors.length)} vertices move`,
    `${length(mean)} in the mean of all`,
  ];
}

/** With so many leading digits, and without a power of ten up to 10²¹. */
export function rounded(value: number, digits: number): string {
  return String(Number(value.toPrecision(digits)));
}

interface Held {
  readonly revision: number;
  /** (vertexCount × 3) where all influences put the vertices. */
  readonly full: Float32Array;
  readonly truncation: Truncation;
}

const truncations = new WeakMap<Evaluation, Held>();
