import { loadPart } from '../core/failure.ts';
import type { TaskModule, TaskName } from './tasks.ts';

/** A seam: every task. A new one is a file, a line here, and its types in tasks.ts. */
export const taskTable: { readonly [Name in TaskName]: () => Promise<TaskModule<Name>> } = {
  'read-characters': () => loadPart(import('./read-characters-task.ts')),
};
