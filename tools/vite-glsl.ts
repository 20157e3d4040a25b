import { readFile } from 'node:fs/promises';
import type { Plugin } from 'vite';

/**
 * Removes comments and blank lines from the shaders that are built into the app. The dev server
 * serves the files unchanged, so that line numbers in compiler messages match the file.
 */
export function shortShaders(): Plugin {
  return {
    name: 'short-shaders',
    apply: 'build',
    enforce: 'pre',
    async load(id) {
      const [file, query] = id.split('?');
      if (!file?.endsWith('.glsl') || query !== 'raw') return null;
      this.addWatchFile(file);
      return `export default ${JSON.stringify(stripGlsl(await readFile(file, 'utf8')))};`;
    },
  };
}

/** Returns the same program without comments, blank lines and most spaces. */
export function stripGlsl(source: string): string {
  return source
    .replace(/\/\*[\s\S]*?\*\/|\/\/.*/g, (comment) => (comment.startsWith('//') ? '' : ' '))
    .split(/\r?\n/)
    .map((line) => (/^\s*#|\\$/.test(line) ? line : tightened(line)).trim())
    .filter((line) => line !== '')
    .map((line) => `${line}\n`)
    .join('');
}

/** Removes spaces around signs; those around a minus stay, because `a - -b` needs them. */
function tightened(line: string): string {
  return line.replace(/\s*([*/=<>(){},;?:])\s*/g, '$1');
}
