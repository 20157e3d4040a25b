import type { LooseFile, LooseOutcome } from './read-characters-task.ts';

/** What each task takes and gives; both cross between threads, their buffers handed over. */
export interface TaskTypes {
  'read-characters': { readonly input: readonly LooseFile[]; readonly output: LooseOutcome };
}

export type TaskName = keyof TaskTypes;

/** How far a task is: what it is at, and how much came before (0 to 1). */
export type TaskProgress = (label: string, fraction: number) => void;

/** A pure function that may run on another thread. */
export interface TaskModule<Name extends TaskName> {
  run(
    input: TaskTypes[Name]['input'],
    onProgress: TaskProgress,
  ): Promise<TaskTypes[Name]['output']>;
}

/** What the worker is asked, once in its life. */
export interface TaskRequest<Name extends TaskName = TaskName> {
  readonly name: Name;
  readonly input: TaskTypes[Name]['input'];
}

/** What the worker answers: progress any number of times, then one of the others; a `Failure` stays one. */
export type TaskReply =
  | { readonly kind: 'progress'; readonly label: string; readonly fraction: number }
  | { readonly kind: 'done'; readonly output: unknown }
  | { readonly kind: 'failed'; readonly message: string; readonly isFailure: boolean };
