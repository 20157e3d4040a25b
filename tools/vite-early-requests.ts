import type { Plugin } from 'vite';

/** The name of the script that reads the first character; see `firstScripts` in vite.config.ts. */
const readingScript = 'reading';

/**
 * Lets the built page request what its first script would ask for later: the scripts that it
 * imports, the one that reads the first character, what that imports, and the list of characters.
 */
export function earlyRequests(): Plugin {
  return {
    name: 'early-requests',
    apply: 'build',
    transformIndexHtml: {
      order: 'post',
      handler(_html, { bundle }) {
        const chunks = Object.values(bundle ?? {}).filter((output) => output.type === 'chunk');
        const early = new Set(chunks.filter(({ isEntry }) => isEntry).flatMap((c) => c.imports));
        const reading = chunks.find(({ name }) => name === readingScript);
        if (!reading) throw new Error(`no script is named ${readingScript}`);
        for (const file of [reading.fileName, ...reading.imports]) early.add(file);
        const scripts = [...early].map((file) => ({
          rel: 'modulepreload',
          href: `./${file}`,
        }));
        const list = { rel: 'preload', as: 'fetch', href: './data/catalogue.json' };
        return [...scripts, list].map((attributes) => ({
          tag: 'link',
          attrs: { ...attributes, crossorigin: true },
          injectTo: 'head',
        }));
      },
    },
  };
}
