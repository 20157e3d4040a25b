import { buildCharacter } from '../core/build-character.ts';
import type { Character } from '../core/character.ts';
import type { Diagnostic } from '../core/diagnostics.ts';
import type { FileEntry } from './format.ts';
import { formats } from './registry.ts';

export interface ReadCharacter {
  readonly character: Character;
  readonly files: readonly FileEntry[];
}

export interface ReadOutcome {
  readonly characters: readonly ReadCharacter[];
  readonly diagnostics: readonly Diagnostic[];
}

/** From any files, in any order, to all the characters among them: the way of every caller. */
export async function readCharacters(files: readonly FileEntry[]): Promise<ReadOutcome> {
  const characters: ReadCharacter[] = [];
  const diagnostics: Diagnostic[] = [];
  let unclaimed = files;
  for (const format of formats) {
    for (const group of format.claim(unclaimed)) {
      unclaimed = unclaimed.filter((file) => !group.files.includes(file));
      const parsed = await format.read(group);
      diagnostics.push(...group.diagnostics, ...parsed.diagnostics);
      if (!parsed.value) continue;
      const built = buildCharacter(parsed.value);
      diagnostics.push(...built.diagnostics);
      if (built.value) characters.push({ character: built.value, files: group.files });
    }
  }
  diagnostics.push(...unclaimed.map(unknownFile));
  return { characters, diagnostics };
}

function unknownFile({ path }: FileEntry): Diagnostic {
  const extensions = formats.flatMap((format) => format.extensions);
  return {
    severity: 'warning',
    code: 'file/unknown',
    file: path,
    expected: `a file that Sinew reads (${extensions.join(', ')})`,
    found: path.slice(-40),
    effect: 'the file is not used',
  };
}
