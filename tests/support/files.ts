import type { Character } from '../../src/core/character.ts';
import { defaultLimits, type Limits } from '../../src/core/limits.ts';
import { memoryFile } from '../../src/formats/file-entry.ts';
import type { FileEntry } from '../../src/formats/format.ts';
import { readCharacters, type ReadOutcome } from '../../src/formats/read-characters.ts';

export type FileContents = Readonly<Record<string, string | Uint8Array>>;

export function bytesOf(content: string | Uint8Array): Uint8Array {
  return typeof content === 'string' ? new TextEncoder().encode(content) : content;
}

export function textOf(bytes: Uint8Array): string {
  return new TextDecoder('utf-8', { ignoreBOM: true }).decode(bytes);
}

/** Files by name, in the order given. */
function filesOf(contents: FileContents): FileEntry[] {
  return Object.entries(contents).map(([path, content]) => memoryFile(path, bytesOf(content)));
}

export function readContents(
  contents: FileContents,
  limits: Partial<Limits> = {},
): Promise<ReadOutcome> {
  return readCharacters(filesOf(contents), undefined, { ...defaultLimits, ...limits });
}

/** The only character in the files; throws with the messages if there is not exactly one. */
export async function readOne(contents: FileContents): Promise<Character> {
  const { characters, diagnostics } = await readContents(contents);
  if (characters.length === 1) return characters[0]!.character;
  throw new Error(`${characters.length} characters: ${JSON.stringify(diagnostics)}`);
}
