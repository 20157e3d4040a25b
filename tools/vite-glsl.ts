import { readFile } from 'node:fs/promises';
import type { Plugin } from 'vite';

/**
 * Leaves comments and blank lines out of the shaders that are built into the app. The dev server
 * gives the files as they are, so that the line numbers of the compiler's messages are the file's.
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

/** The same program without comments, blank lines and spaces at the ends of lines. */
export function stripGlsl(source: string): string {
  return source
    .replace(/\/\*[\s\S]*?\*\/|\/\/.*/g, (comment) => (comment.startsWith('//') ? '' : ' '))
    .split(/\r?\n/)
    .map((line) => line.trim())
    .filter((line) => line !== '')
    .map((line) => `${line}\n`)
    .join('');
}
