import { existsSync, readdirSync } from 'node:fs';
import { dirname, basename, join } from 'node:path';

/**
 * Finds an existing path that equals the given one except for Unicode composition: macOS stores
 * decomposed names, while keyboards type composed ones. Returns the path as given if there is none.
 */
export function existingPath(path: string): string {
  const folder = dirname(path);
  if (folder === path || existsSync(path)) return path;
  const existing = existingPath(folder);
  const name = basename(path).normalize('NFC');
  try {
    const found = readdirSync(existing).find((each) => each.normalize('NFC') === name);
    return found === undefined ? path : join(existing, found);
  } catch {
    return path;
  }
}
