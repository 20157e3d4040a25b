/**
 * Runs one group in a process of its own, so that no group finds the engine as another one left it:
 * functions that were compiled for other data are slower. bench/main.ts starts it and gets the
 * result as a message.
 */
import type { GroupId } from './goals.ts';
import { groups } from './groups/registry.ts';
import type { BenchOptions } from './harness/group.ts';

process.once('message', ({ id, options }: { id: GroupId; options: BenchOptions }) => {
  void run(id, options);
});

async function run(id: GroupId, options: BenchOptions): Promise<void> {
  try {
    process.send!({ result: await groups[id](options) });
  } catch (error) {
    process.send!({ message: error instanceof Error ? error.message : String(error) });
  } finally {
    process.disconnect();
  }
}
