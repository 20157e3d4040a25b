import type { Character, CharacterImage } from '../core/character.ts';
import { textureExtensions } from './extensions.ts';
import { baseName, extensionOf } from './file-entry.ts';
import type { FileEntry } from './format.ts';

/**
 * The image that a material names, among files in any folder, case aside; never fetched from where the
 * name points to.
 */
function findTexture(files: readonly FileEntry[], name: string): FileEntry | undefined {
  const wanted = baseName(name).toLowerCase();
  return files.find(({ path }) => isImage(path) && baseName(path).toLowerCase() === wanted);
}

/**
 * The character with the images that its materials name, from among the files; those that are not there
 * stand among what is missing, by name.
 */
export async function attachTextures(
  character: Character,
  files: readonly FileEntry[],
): Promise<{ readonly character: Character; readonly used: readonly FileEntry[] }> {
  const names = character.materials.flatMap(({ texture }) => texture ?? []);
  const used: FileEntry[] = [];
  const images: CharacterImage[] = [];
  const missing: string[] = [];
  for (const name of new Set(names.map((name) => baseName(name)))) {
    const file = findTexture(files, name);
    if (!file) {
      missing.push(name);
      continue;
    }
    used.push(file);
    images.push({ name, bytes: await file.bytes() });
  }
  for (const name of character.optionalImages) {
    const file = findTexture(files, name);
    if (file) used.push(file);
  }
  if (names.length === 0) return { character, used };
  return { character: { ...character, images, missing: [...character.missing, ...missing] }, used };
}

function isImage(path: string): boolean {
  return textureExtensions.includes(extensionOf(path));
}
