import { fork } from 'node:child_process';
import path from 'node:path';
import type { GroupId } from '../goals.ts';
import type { BenchOptions, GroupResult } from './group.ts';

const file = path.join(import.meta.dirname, '../run-group.ts');

/** Runs a group in a process of its own. Rejects with its message if it ends without a result. */
export function startGroup(id: GroupId, options: BenchOptions): Promise<GroupResult> {
  return new Promise((resolve, reject) => {
    const child = fork(file);
    child.once('message', (reply: { result?: GroupResult; message?: string }) => {
      if (reply.result) resolve(reply.result);
      else reject(new Error(`${id}: ${reply.message ?? ''}`));
    });
    child.once('exit', (code) => reject(new Error(`${id} ended with code ${code}`)));
    child.send({ id, options });
  });
}
