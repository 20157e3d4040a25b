/**
 * The hash of everything that the bundled command line is made from. The bundle carries it, so that
 * a bundle of older sources is never run.
 */
import { createHash } from 'node:crypto';
import { readdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { root } from './commands.mjs';

/** Folders and files, relative to the project. */
const sources = ['src', 'package-lock.json', 'vite.cli.config.ts'];

/**
 * Returns a hash over the names and the contents of the sources, in hexadecimal.
 * @returns {string}
 */
export function sourcesHash() {
  const hash = createHash('sha256');
  for (const file of sources.flatMap(filesOf)) {
    const bytes = readFileSync(path.join(root, file));
    hash.update(`${file} ${bytes.length}\n`).update(bytes);
  }
  return hash.digest('hex');
}

/**
 * @param {string} name
 * @returns {string[]} sorted, with "/" between folders
 */
function filesOf(name) {
  if (path.extname(name) !== '') return [name];
  const entries = readdirSync(path.join(root, name), { withFileTypes: true, recursive: true });
  return entries
    .filter((entry) => entry.isFile())
    .map((entry) => path.relative(root, path.join(entry.parentPath, entry.name)))
    .map((file) => file.split(path.sep).join('/'))
    .sort();
}
