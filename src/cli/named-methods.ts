import type { MethodId } from '../skinning/method.ts';
import { type KernelRow, methods } from '../skinning/registry.ts';
import { UsageError } from './usage-error.ts';

/** The short names of all methods. */
export const methodNames: readonly string[] = methods.map(({ short }) => short);

/** The method with this id or short name. */
export function methodNamed(option: string, word: string): KernelRow<MethodId> {
  const found = methods.find(({ id, short }) => word === id || word === short);
  if (!found)
    throw new UsageError(`expected ${option} of ${methodNames.join('|')}, found "${word}"`);
  return found;
}

/** The methods of a list with commas, each once, in its order; all of them without a list. */
export function methodsNamed(option: string, words: string | undefined): KernelRow<MethodId>[] {
  if (words === undefined) return [...methods];
  return [...new Set(words.split(',').map((word) => methodNamed(option, word.trim())))];
}
