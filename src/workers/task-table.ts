import { loadPart } from '../core/failure.ts';
import type { TaskModule, TaskName } from './tasks.ts';

/** Every task. To add one, write a file, add a line here, and add its types to tasks.ts. */
export const taskTable: { readonly [Name in TaskName]: () => Promise<TaskModule<Name>> } = {
  'read-characters': () => loadPart(import('./read-characters-task.ts')),
  measure: () => loadPart(import('./measure-task.ts')),
  'prepare-method': () => loadPart(import('./prepare-method-task.ts')),
};
