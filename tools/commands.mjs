/**
 * Shared by the scripts of this folder: where the project is, and how to run its programs. These
 * files run before anything is installed, so they are plain JavaScript that needs only Node.
 */
import { existsSync, readFileSync, realpathSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '..');

/** Generated files that can be deleted at any time: caches, reports, the fallback browser. */
export const cacheFolder = path.join(root, '.cache');

/**
 * Returns the command line that runs an installed package's program. Node runs the script itself,
 * because the wrappers in node_modules/.bin are shell scripts on Windows, which need a shell and
 * quoting.
 * @param {string} packageName
 * @param {string[]} words
 * @returns {string[]}
 */
export function packageCommand(packageName, words = [], program = packageName.split('/').at(-1)) {
  const folder = path.join(root, 'node_modules', packageName);
  /** @type {{ bin?: string | Record<string, string> }} */
  const { bin } = readJson(path.join(folder, 'package.json'));
  const script = typeof bin === 'string' ? bin : bin?.[program ?? ''];
  if (script === undefined) throw new Error(`${packageName} has no program ${program ?? ''}`);
  return [process.execPath, path.join(folder, script), ...words];
}

/**
 * Returns the command line that runs npm: the same npm that started this process, if there is one.
 * @param {string[]} words
 * @returns {string[]}
 */
export function npmCommand(words) {
  const script = process.env['npm_execpath'];
  if (script !== undefined && /npm-cli\.[cm]?js$/.test(script) && existsSync(script)) {
    return [process.execPath, script, ...words];
  }
  if (process.platform !== 'win32') return ['npm', ...words];
  const beside = path.join(path.dirname(process.execPath), 'node_modules/npm/bin/npm-cli.js');
  return [process.execPath, beside, ...words];
}

/**
 * @param {string} file
 * @returns {any}
 */
export function readJson(file) {
  return JSON.parse(readFileSync(file, 'utf8'));
}

/**
 * Returns the first of these names that is a program on PATH.
 * @param {string[]} names
 * @returns {string | undefined}
 */
export function findOnPath(names) {
  const folders = (process.env['PATH'] ?? '').split(path.delimiter).filter((each) => each !== '');
  const endings = process.platform === 'win32' ? ['.exe'] : [''];
  for (const name of names) {
    for (const folder of folders) {
      for (const ending of endings) {
        const file = path.join(folder, name + ending);
        if (existsSync(file)) return file;
      }
    }
  }
  return undefined;
}

/**
 * Whether Node was started with this file, instead of another file importing it.
 * @param {string} moduleUrl
 */
export function isMain(moduleUrl) {
  const started = process.argv[1];
  return started !== undefined && realpathSync(started) === fileURLToPath(moduleUrl);
}
