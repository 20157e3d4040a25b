import type { Vector3 } from '../../posing/ik/problem.ts';
import type { Evaluation } from '../evaluation.ts';

/**
 * How a method brings a point of the mesh to its place, computed in float64. Places are in the
 * character's space and in its units.
 */
export interface Explanation {
  /** Before the method: the point after rest layers. */
  readonly rest: Vector3;
  readonly place: Vector3;
  /** Where single joints would take the point. */
  readonly ghosts: readonly Ghost[];
  /** Further places on the way. */
  readonly marks: readonly Mark[];
  /** What is computed, in its order. The rows of the last step sum to the place. */
  readonly steps: readonly ExplainedStep[];
  /** What is special at this point, as a sentence. */
  readonly note?: string;
}

export interface Ghost {
  /** Of the palette. */
  readonly entry: number;
  readonly weight: number;
  readonly place: Vector3;
}

export interface Mark {
  readonly label: string;
  readonly place: Vector3;
}

/** A table of numbers whose columns have names. */
export interface ExplainedStep {
  readonly title: string;
  readonly columns: readonly string[];
  readonly rows: readonly ExplainedRow[];
  /** The sum of all rows, or none if they are not summed. */
  readonly total: readonly number[] | null;
}

export interface ExplainedRow {
  /** A palette entry, or a name. */
  readonly of: number | string;
  readonly values: readonly number[];
}

/** Explains a point of the mesh that is shown. */
export type Explain = (evaluation: Evaluation, point: number) => Explanation;
