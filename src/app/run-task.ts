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
  /** When aborted, the task ends without a result. */
  readonly signal: AbortSignal;
  readonly onProgress: TaskProgress;
  /** Buffers of the input, which are transferred and empty afterwards. */
  readonly transfer: Transferable[];
}

/** The part of Trusted Types that is used here; not every browser has it. */
interface TrustedTypes {
  createPolicy(
    name: string,
    rules: { createScriptURL(): string },
    // a TrustedScriptURL object; `Worker` accepts it in place of a string
  ): { createScriptURL(text: string): string };
}

const { trustedTypes } = globalThis as { readonly trustedTypes?: TrustedTypes };

/**
 * The page's content policy does not let a plain string start a worker. The only trusted-types
 * policy that it allows returns this one address, whatever it is given.
 */
const trustedUrl =
  trustedTypes
    ?.createPolicy('skin-worker', { createScriptURL: () => workerUrl })
    .createScriptURL('') ?? workerUrl;

/** Runs a task in a worker, which is terminated when the task ends. */
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
      else if (data.kind === 'done') resolve(data.output);
      else reject(data.isFailure ? new Failure(data.message) : new Error(data.message));
    });
    worker.addEventListener('error', () =>
      reject(new Failure('A part of Sinew could not be loaded; reload the page')),
    );
    worker.postMessage({ name, input } satisfies TaskRequest, transfer);
  }).finally(() => worker.terminate());
}
