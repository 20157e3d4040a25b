import { diagonal } from '../../core/bounds.ts';
import type { Evaluation } from '../evaluation.ts';
import { type Difference, differenceOf, leastPart } from './difference.ts';
import { rowSumDifference } from './row-sums.ts';
import { volumeRatioOf } from './volume.ts';

/** What a method does to a pose, as numbers. */
export interface MethodNumbers {
  /** How far its points are from those of the base, in model units. */
  readonly difference: Difference;
  /** Its volume as a part of that at rest; null if the mesh encloses none. */
  readonly volume: number | null;
  /** See `rowSumDifference`. */
  readonly bySums: Difference | null;
}

/** Compares evaluations of one character in one pose, by different methods, with one of them. */
export function compareWith(
  base: Evaluation,
  evaluations: readonly Evaluation[],
): readonly MethodNumbers[] {
  const from = base.vertices().positions;
  const least = leastPart * diagonal(base.state.character.bounds);
  return evaluations.map((evaluation) => {
    const { positions } = evaluation.vertices();
    return {
      difference: differenceOf(positions, from, evaluation.rest.pointCount, least),
      volume: volumeRatioOf(evaluation),
      bySums: rowSumDifference(evaluation),
    };
  });
}
