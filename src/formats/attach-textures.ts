import type { Character } from '../core/character.ts';
import { textureExtensions } from './extensions.ts';
import { baseName, extensionOf } from './file-entry.ts';
import type { FileEntry } from './format.ts';

/**
 * The image that a material names, among files in any folder, case aside; never fetched from where the
 * name points to.
 */
export function findTexture(files: readonly FileEntry[], name: string): FileEntry | undefined {
  const wanted = baseName(name).toLowerCase();
  return files.find(({ path }) => isImage(path) && baseName(path).toLowerCase() === wanted);
}

/** The images that a character's materials name, and those that shade them, each once. */
export function texturesOf(
  { materials, mmd }: Character,
  files: readonly FileEntry[],
): FileEntry[] {
  const names = materials.flatMap(({ texture }) => (texture === undefined ? [] : [texture]));
  const found = [...names, ...(mmd?.toons ?? [])].flatMap((name) => findTexture(files, name) ?? []);
  return [...new Set(found)];
}

/** Endings of the images that materials name and that are not there. */
export function missingTextures(
  { materials }: Character,
  files: readonly FileEntry[],
): readonly string[] {
  const missing = materials.flatMap(({ texture }) =>
    texture === undefined || findTexture(files, texture) ? [] : [extensionOf(texture)],
  );
  return [...new Set(missing)].filter((ending) => textureExtensions.includes(ending));
}

function isImage(path: string): boolean {
  return textureExtensions.includes(extensionOf(path));
}
