import type { Character, CharacterImage } from '../core/character.ts';
import { type Diagnostic, printablePath } from '../core/diagnostics.ts';
import { ambiguousName } from './belonging/ambiguous-name.ts';
import { findNamed } from './belonging/find-named.ts';
import { grouped } from './belonging/grouped.ts';
import { plainPath } from './belonging/plain-path.ts';
import { textureExtensions } from './extensions.ts';
import { baseName, extensionOf } from './file-entry.ts';
import type { FileEntry } from './format.ts';
import { isLfsPointer, lfsPointer } from './text/lfs-pointer.ts';

interface Dressed {
  readonly character: Character;
  readonly used: readonly FileEntry[];
  readonly diagnostics: readonly Diagnostic[];
}

/**
 * Returns the character with the images that its materials name. Images are taken from the given
 * files and never fetched. The names of missing images are added to `missing`.
 *
 * @param from the file that has the materials
 */
export async function attachTextures(
  character: Character,
  from: FileEntry,
  files: readonly FileEntry[],
): Promise<Dressed> {
  const candidates = files.filter(({ path }) => isImage(path));
  const used: FileEntry[] = [];
  const images: CharacterImage[] = [];
  const missing: string[] = [];
  const guessed: FileEntry[] = [];
  const pointers: FileEntry[] = [];
  const diagnostics: Diagnostic[] = [];
  const all = new Set(character.materials.flatMap(({ texture }) => texture ?? []));
  const named = grouped(Array.from(all, (texture) => [plainPath(texture), texture] as const));
  for (const [name, textures] of named) {
    const texture = textures[0]!;
    const found = findNamed(texture, from.path, candidates);
    if (!found) {
      missing.push(baseName(texture));
      continue;
    }
    used.push(found.file);
    const bytes = await found.file.bytes();
    if (isLfsPointer(bytes)) {
      pointers.push(found.file);
      continue;
    }
    images.push({ name, textures, bytes });
    diagnostics.push(...ambiguousName(from, texture, found));
    if (found.isGuess) guessed.push(found.file);
  }
  for (const name of character.optionalImages) {
    const found = findNamed(name, from.path, candidates);
    if (found) used.push(found.file);
  }
  if (pointers.length > 0) diagnostics.push(tellPointers(pointers));
  if (guessed.length > 0) diagnostics.push(tellGuesses(from, guessed));
  const dressed = { ...character, images, missing: [...character.missing, ...new Set(missing)] };
  return { character: named.size === 0 ? character : dressed, used, diagnostics };
}

/** Reports once for all images that Git LFS has not brought. */
function tellPointers(pointers: readonly FileEntry[]): Diagnostic {
  const [first, ...others] = pointers.map(({ path }) => baseName(path));
  const file = others.length > 0 ? `${first!} and ${others.length} more` : first!;
  return { severity: 'warning', file, ...lfsPointer, effect: 'the image is not used' };
}

/** Leaves room for a count in what a message shows as found. */
const longestPath = 28;

/** Reports guesses once per character, however many images it has. */
function tellGuesses(from: FileEntry, guessed: readonly FileEntry[]): Diagnostic {
  const [first, ...others] = guessed.map(({ path }) => printablePath(path, longestPath));
  return {
    severity: 'warning',
    code: 'file/pairing',
    file: baseName(from.path),
    expected: 'images where its materials say, or beside it',
    found: others.length > 0 ? `${first!} and ${others.length} more` : first!,
    effect: `${first!}${others.length > 0 ? ' and the others are' : ' is'} used, by name`,
  };
}

function isImage(path: string): boolean {
  return textureExtensions.includes(extensionOf(path));
}
