import type { Character } from '../core/character.ts';
import type { Diagnostic } from '../core/diagnostics.ts';
import { memoryFile } from '../formats/file-entry.ts';
import { readCharacters, type ReadProgress } from '../formats/read-characters.ts';

/** A file as it is passed between threads; its bytes are transferred, not copied. */
export interface LooseFile {
  readonly path: string;
  readonly bytes: Uint8Array;
}

export interface LooseOutcome {
  readonly characters: readonly {
    readonly character: Character;
    readonly files: readonly LooseFile[];
  }[];
  readonly diagnostics: readonly Diagnostic[];
}

/** Runs `readCharacters` on files that were passed between threads. */
export async function run(
  files: readonly LooseFile[],
  onProgress: ReadProgress,
): Promise<LooseOutcome> {
  const entries = files.map(({ path, bytes }) => memoryFile(path, bytes));
  const { characters, diagnostics } = await readCharacters(entries, onProgress);
  return {
    characters: await Promise.all(
      characters.map(async ({ character, files: own }) => ({
        character,
        files: await Promise.all(
          own.map(async (file) => ({ path: file.path, bytes: await file.bytes() })),
        ),
      })),
    ),
    diagnostics,
  };
}
