import { defineConfig, type Connect, type Plugin } from 'vite';
import { contentPolicy } from './tools/vite-content-policy.ts';
import { pureGlMatrix } from './tools/vite-gl-matrix.ts';
import { shortShaders } from './tools/vite-glsl.ts';
import { wasmKernel } from './tools/vite-kernel.ts';

const jsx = { runtime: 'automatic', importSource: 'preact' } as const;

export default defineConfig({
  // Addresses are relative to the page, so that the built folder works at any path.
  base: './',
  // There is one page. An unknown address gives error 404 instead of the page.
  appType: 'mpa',
  plugins: [shortShaders(), wasmKernel(), pureGlMatrix(), contentPolicy(), packedAsTheyAre()],
  oxc: { jsx },
  optimizeDeps: { entries: ['index.html'], rolldownOptions: { transform: { jsx } } },
  build: {
    target: 'es2022',
    sourcemap: false,
    modulePreload: false,
    // Small files are not inlined, because a strict content policy allows no data: addresses.
    assetsInlineLimit: 0,
  },
  worker: { format: 'es', plugins: () => [pureGlMatrix()] },
});

/**
 * Vite's servers send a file NAME.gz as NAME with a content encoding, and the browser unpacks it.
 * Plain hosts such as GitHub Pages send the file unchanged. This plugin does the same, so that
 * development and tests meet the same conditions as the hosted page. Vite keeps headers that are
 * set here.
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
