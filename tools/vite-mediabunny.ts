import type { Plugin } from 'vite';

const nothing = '\0no-files-of-node';

/**
 * mediabunny has one module for Node's files, which its package leaves out for browsers. Vite would
 * put an empty CommonJS module in its place, whose helpers the first scripts would carry too; this
 * puts an empty module of the other kind there.
 */
export function withoutNodeFiles(): Plugin {
  return {
    name: 'mediabunny-without-node-files',
    enforce: 'pre',
    resolveId: (source, importer) =>
      source === './node.js' && importer?.includes('/mediabunny/') ? nothing : undefined,
    load: (id) => (id === nothing ? 'export const fs = undefined;' : undefined),
  };
}
