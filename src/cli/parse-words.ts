import { UsageError } from './usage-error.ts';

/** Turns the error that `parseArgs` throws for unknown or incomplete options into a usage error. */
export function parseWords<T>(parse: () => T): T {
  try {
    return parse();
  } catch (error) {
    throw new UsageError(error instanceof Error ? error.message : String(error));
  }
}

/** Joins an option and its value, because `parseArgs` would take `-1,0` for another option. */
export function joinValue(words: readonly string[], option: string): string[] {
  const at = words.indexOf(option);
  if (at === -1 || at + 1 >= words.length) return [...words];
  return [...words.slice(0, at), `${option}=${words[at + 1]!}`, ...words.slice(at + 2)];
}
