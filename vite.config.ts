import { defineConfig, type Connect, type Plugin } from 'vite';
import { contentPolicy } from './tools/vite-content-policy.ts';
import { pureGlMatrix } from './tools/vite-gl-matrix.ts';
import { shortShaders } from './tools/vite-glsl.ts';

const jsx = { runtime: 'automatic', importSource: 'preact' } as const;

export default defineConfig({
  // Addresses relative to the page: the built folder works wherever it is put.
  base: './',
  // One page: an address without a file is an error 404, never the page again.
  appType: 'mpa',
  plugins: [shortShaders(), pureGlMatrix(), contentPolicy(), packedAsTheyAre()],
  oxc: { jsx },
  optimizeDeps: { entries: ['index.html'], rolldownOptions: { transform: { jsx } } },
  build: {
    target: 'es2022',
    sourcemap: false,
    modulePreload: false,
    // Small files stay files: a strict content policy allows no data: addresses.
    assetsInlineLimit: 0,
  },
  worker: { format: 'es', plugins: () => [pureGlMatrix()] },
});

/**
 * Vite's servers say of a file NAME.gz that it is NAME, packed for the way, and the browser unpacks
 * it. Plain hosts, GitHub Pages among them, send it as it is. So do we, so that what is developed
 * and tested is what the hosted page meets. What is set here, Vite leaves alone.
 */
function packedAsTheyAre(): Plugin {
  const handle: Connect.NextHandleFunction = (request, response, next) => {
    if (/\.gz(\?|$)/.test(request.url ?? '')) {
      response.setHeader('Content-Encoding', 'identity');
      response.setHeader('Content-Type', 'application/gzip');
    }
    next();
  };
  return {
    name: 'packed-as-they-are',
    configureServer: (server) => void server.middlewares.use(handle),
    configurePreviewServer: (server) => void server.middlewares.use(handle),
  };
}
