import { Failure } from '../core/failure.ts';
import workerUrl from '../workers/task.worker.ts?worker&url';
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

/** The part of Trusted Types that is used here, which not every browser has. */
interface TrustedTypes {
  createPolicy(
    name: string,
    rules: { createScriptURL(): string },
  ): { createScriptURL(text: string): string }; // an object, which `Worker` takes for a text
}

const { trustedTypes } = globalThis as { readonly trustedTypes?: TrustedTypes };

/**
 * The page's content policy starts no worker from plain text. The one trusted policy that it allows gives
 * this one address, whatever it is asked for.
 */
const trustedUrl =
  trustedTypes
    ?.createPolicy('skin-worker', { createScriptURL: () => workerUrl })
    .createScriptURL('') ?? workerUrl;

/** Runs a task on another thread, which ends with it. */
export function runTask<Name extends TaskName>(
  name: Name,
  input: TaskTypes[Name]['input'],
  { signal, onProgress, transfer }: TaskOptions,
): Promise<TaskTypes[Name]['output'] | undefined> {
  const worker = new Worker(trustedUrl, { type: 'module' });
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
