import type { CharacterImage } from '../core/character.ts';
import { plainName, withPlainPaths } from './belonging/plain-path.ts';
import type { OutputFile } from './format.ts';

/**
 * Returns files as they are saved, in one folder, with images at the paths that the materials name.
 * The names come from files that anyone may have written, so each becomes a plain path, and no path
 * occurs twice.
 */
export function savedFiles(
  written: readonly OutputFile[],
  images: readonly CharacterImage[] = [],
): OutputFile[] {
  return withPlainPaths([
    ...written.map(({ path, bytes }) => ({ path: plainName(path), bytes })),
    ...images.map(({ name, bytes }) => ({ path: name, bytes })),
  ]);
}
