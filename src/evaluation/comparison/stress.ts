import type { Actor } from '../../document/scene.ts';
import type { MethodId } from '../../skinning/method.ts';
import type { EvaluationPool } from '../evaluation-pool.ts';
import { Evaluator } from '../evaluator.ts';
import { compareWith } from './compare.ts';
import { type CharacterSize, sizeOf } from './difference.ts';
import type { StressPose } from './stress-poses.ts';

/** What a method does to a pose, without the distance of every point. */
export interface StressNumbers {
  /** From the base, in model units. */
  readonly largest: number;
  /** The point where it is largest. */
  readonly worst: number;
  readonly mean: number;
  /** As a part of that at rest; null if the mesh encloses none. */
  readonly volume: number | null;
}

/** A pose of the suite under all methods. */
export interface StressRow {
  readonly pose: StressPose;
  /** In the order of the methods. */
  readonly numbers: readonly StressNumbers[];
  /** The largest difference of any method from the base. */
  readonly largest: number;
}

/** What several methods do to a character in the extremes of its joints. */
export interface StressSuite {
  readonly methods: readonly MethodId[];
  /** The method from which differences are counted: an index of the methods. */
  readonly base: number;
  readonly size: CharacterSize;
  /** In the order of the joints. */
  readonly rows: readonly StressRow[];
}

/**
 * Measures methods in each pose as `compareWith` does in one.
 *
 * The kernels and layers of the actor must be loaded for every method. It gives back the part that is
 * done after each method of a pose, so that its caller can take its time.
 *
 * @param actor without a clip and pins, which would change the pose
 * @param base an index of the methods
 */
export function* stressOf(
  pool: EvaluationPool,
  actor: Actor,
  methods: readonly MethodId[],
  base: number,
  poses: readonly StressPose[],
): Generator<number, StressSuite> {
  const evaluators = methods.map((method) => new Evaluator({ ...actor, method }, pool));
  const rows: StressRow[] = [];
  let done = 0;
  try {
    for (const pose of poses) {
      for (const [i, evaluator] of evaluators.entries()) {
        evaluator.evaluate({ ...actor, method: methods[i]!, q: pose.q }, 0).vertices();
        yield ++done / (poses.length * methods.length);
      }
      const numbers = compareWith(evaluators[base]!, evaluators).map(
        ({ difference: { largest, worst, mean }, volume }) => ({ largest, worst, mean, volume }),
      );
      const largest = numbers.reduce((most, each) => Math.max(most, each.largest), 0);
      rows.push({ pose, numbers, largest });
    }
  } finally {
    for (const evaluator of evaluators) evaluator.dispose();
  }
  return { methods, base, size: sizeOf(actor.character), rows };
}

/** The rows with the largest differences first; equal ones in the order of the joints. */
export function worstFirst(rows: readonly StressRow[]): readonly StressRow[] {
  return rows.toSorted((a, b) => b.largest - a.largest);
}
