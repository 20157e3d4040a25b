import { UsageError } from './usage-error.ts';

/** Turns the error that `parseArgs` throws for unknown or incomplete options into a usage error. */
export function parseWords<T>(parse: () => T): T {
  try {
    return parse();
  } catch (error) {
    throw new UsageError(error instanceof Error ? error.message : String(error));
  }
}
