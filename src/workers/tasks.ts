import type {
  MeasurementInput,
  MeasurementKind,
  MeasurementResult,
} from '../evaluation/comparison/measurement.ts';
import type { PrepareInput } from './prepare-method-task.ts';
import type { LooseFile, LooseOutcome } from './read-characters-task.ts';

/**
 * The input and output of each task. Both are passed between threads, and their buffers are
 * transferred.
 */
export interface TaskTypes {
  'read-characters': { readonly input: readonly LooseFile[]; readonly output: LooseOutcome };
  measure: {
    readonly input: MeasurementInput;
    readonly output: MeasurementResult<MeasurementKind>;
  };
  'prepare-method': { readonly input: PrepareInput; readonly output: unknown };
}

export type TaskName = keyof TaskTypes;

/** Reports progress: the current activity, and the fraction that is done (0 to 1). */
export type TaskProgress = (label: string, fraction: number) => void;

/** A pure function that may run on another thread. */
export interface TaskModule<Name extends TaskName> {
  run(
    input: TaskTypes[Name]['input'],
    onProgress: TaskProgress,
  ): Promise<TaskTypes[Name]['output']>;
}

/** The request to the worker; each worker gets exactly one. */
export interface TaskRequest<Name extends TaskName = TaskName> {
  readonly name: Name;
  readonly input: TaskTypes[Name]['input'];
}

/**
 * The reply of the worker: progress any number of times, then one of the others. A `Failure` stays
 * a `Failure`.
 */
export type TaskReply =
  | { readonly kind: 'progress'; readonly label: string; readonly fraction: number }
  | { readonly kind: 'done'; readonly output: unknown }
  | { readonly kind: 'failed'; readonly message: string; readonly isFailure: boolean };
