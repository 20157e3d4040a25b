import { buffersOf } from '../core/buffers-of.ts';
import { Failure } from '../core/failure.ts';
import { taskTable } from './task-table.ts';
import type { TaskName, TaskReply, TaskRequest } from './tasks.ts';

/** The worker of every task: runs the requested task and transfers its result. */
addEventListener('message', ({ data }: MessageEvent<TaskRequest>) => void answer(data));

async function answer<Name extends TaskName>({ name, input }: TaskRequest<Name>): Promise<void> {
  try {
    const task = await taskTable[name]();
    const output = await task.run(input, (label, fraction) =>
      reply({ kind: 'progress', label, fraction }),
    );
    reply({ kind: 'done', output }, buffersOf(output));
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    reply({ kind: 'failed', message, isFailure: error instanceof Failure });
  }
}

function reply(message: TaskReply, transfer: Transferable[] = []): void {
  postMessage(message, { transfer });
}
