import type {
  MeasurementInput,
  MeasurementKind,
  MeasurementResult,
} from '../evaluation/comparison/measurement.ts';
import type { PrepareControl } from '../evaluation/preparation.ts';
import { runTask } from './run-task.ts';

/** Measures in a worker, which gets copies; returns undefined if the signal ends it. */
export function measureInWorker<Kind extends MeasurementKind>(
  input: MeasurementInput<Kind>,
  { signal, onProgress }: PrepareControl,
): Promise<MeasurementResult<Kind> | undefined> {
  return runTask('measure', input, {
    signal,
    onProgress: (_, part) => onProgress(part),
    transfer: [],
  });
}
