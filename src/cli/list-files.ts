import { readdirSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { isJunk } from '../formats/junk.ts';

/** Limits the listing, because the given folder may be the root of a disk. */
const largestCount = 10_000;

/**
 * Lists the path itself or, for a folder, all files in it and in its subfolders, sorted by name.
 * Throws if the path does not exist or the folder is empty. Links are not followed, because they
 * may form cycles.
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
