import { oneWord } from './cse169/write-skel.ts';
import type { FormatShape } from './format.ts';
import { fittedNames } from './mmd/fitted-names.ts';

/** Returns the names of joints as a format that has names writes them. */
export function writtenNames(
  names: readonly string[],
  kind: Exclude<FormatShape['jointNames'], false>,
): string[] {
  return kind === 'words' ? names.map(oneWord) : fittedNames(names, 20);
}
