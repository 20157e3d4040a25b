import { Failure } from '../core/failure.ts';
import type {
  TaskName,
  TaskProgress,
  TaskReply,
  TaskRequest,
  TaskTypes,
} from '../workers/tasks.ts';

interface TaskOptions {
  /** Once aborted, the task ends and gives nothing. */
  readonly signal: AbortSignal;
  readonly onProgress: TaskProgress;
  /** Buffers of the input, which are handed over and are empty afterwards. */
  readonly transfer: Transferable[];
}

/** Runs a task on another thread, which ends with it. */
export function runTask<Name extends TaskName>(
  name: Name,
  input: TaskTypes[Name]['input'],
  { signal, onProgress, transfer }: TaskOptions,
): Promise<TaskTypes[Name]['output'] | undefined> {
  const worker = new Worker(new URL('../workers/task.worker.ts', import.meta.url), {
    type: 'module',
  });
  return new Promise<TaskTypes[Name]['output'] | undefined>((resolve, reject) => {
    signal.addEventListener('abort', () => resolve(undefined), { once: true });
    worker.addEventListener('message', ({ data }: MessageEvent<TaskReply>) => {
      if (data.kind === 'progress') onProgress(data.label, data.fraction);
      else if (data.kind === 'done') resolve(data.output as TaskTypes[Name]['output']);
      else reject(data.isFailure ? new Failure(data.message) : new Error(data.message));
    });
    worker.addEventListener('error', () =>
      reject(new Failure('A part of Sinew could not be loaded; reload the page')),
    );
    worker.postMessage({ name, input } satisfies TaskRequest, transfer);
  }).finally(() => worker.terminate());
}
