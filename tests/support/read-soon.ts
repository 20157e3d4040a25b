import { expect } from 'vitest';
import type { Limits } from '../../src/core/limits.ts';
import type { ReadOutcome } from '../../src/formats/read-characters.ts';
import { cpuTime } from './cpu-time.ts';
import { type FileContents, readContents } from './files.ts';

/**
 * Milliseconds; a guard against hanging, about twenty times the time of the slowest file on a quiet
 * machine.
 */
const longestRead = 10_000;

export async function readSoon(
  contents: FileContents,
  limits?: Partial<Limits>,
): Promise<ReadOutcome> {
  let outcome: ReadOutcome = { characters: [], diagnostics: [] };
  const time = await cpuTime(async () => (outcome = await readContents(contents, limits)));
  expect(time).toBeLessThan(longestRead);
  return outcome;
}
