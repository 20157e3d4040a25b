import { existsSync, readdirSync } from 'node:fs';
import { dirname, basename, join } from 'node:path';

/**
 * The path, or the one that is there whose names differ from it only in how they are composed: macOS keeps
 * decomposed names, keyboards write composed ones. As given where there is none.
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
