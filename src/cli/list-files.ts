import { readdirSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { isJunk } from '../formats/junk.ts';

/** A folder may hold a whole disk. */
const largestCount = 10_000;

/**
 * The path itself, or for a folder all files in it and in its folders, by name; throws where there
 * is neither. Links are not followed, since they may lead in circles.
 */
export function listFiles(path: string): string[] {
  if (!statSync(path).isDirectory()) return [path];
  const files: string[] = [];
  const pending = [path];
  for (let folder = pending.pop(); folder !== undefined; folder = pending.pop()) {
    const entries = readdirSync(folder, { withFileTypes: true })
      .filter(({ name }) => !isJunk(name))
      .sort((a, b) => (a.name < b.name ? -1 : 1));
    for (const entry of entries) {
      if (entry.isFile()) files.push(join(folder, entry.name));
      if (files.length >= largestCount) return files;
    }
    const folders = entries.filter((entry) => entry.isDirectory());
    for (const { name } of folders.toReversed()) pending.push(join(folder, name));
  }
  if (files.length === 0) throw new Error('an empty folder');
  return files;
}
