import {
  measure,
  type MeasurementInput,
  type MeasurementKind,
  type MeasurementResult,
} from '../evaluation/comparison/measurement.ts';
import type { TaskProgress } from './tasks.ts';

/** Measures what skinning methods do to a character in many poses. */
export function run(
  input: MeasurementInput,
  onProgress: TaskProgress,
): Promise<MeasurementResult<MeasurementKind>> {
  return measure(input, (part) => onProgress('', part));
}
