import type { Plugin } from 'vite';

/** The name of the script that reads the first character; see `firstScripts` in vite.config.ts. */
const readingScript = 'reading';

/**
 * Lets the built page request what its first script would ask for later: the list of characters
 * and the script that reads the first of them.
 */
export function earlyRequests(): Plugin {
  return {
    name: 'early-requests',
    apply: 'build',
    transformIndexHtml: {
      order: 'post',
      handler(_html, { bundle }) {
        const reading = Object.values(bundle ?? {}).find(
          (output) => output.type === 'chunk' && output.name === readingScript,
        );
        if (!reading) throw new Error(`no script is named ${readingScript}`);
        const list = { rel: 'preload', as: 'fetch', href: './data/catalogue.json' };
        const script = { rel: 'modulepreload', href: `./${reading.fileName}` };
        return [list, script].map((attributes) => ({
          tag: 'link',
          attrs: { ...attributes, crossorigin: true },
          injectTo: 'head',
        }));
      },
    },
  };
}
