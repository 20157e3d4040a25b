import { defineConfig, type Connect, type Plugin } from 'vite';
import { contentPolicy } from './tools/vite-content-policy.ts';
import { earlyRequests } from './tools/vite-early-requests.ts';
import { pureGlMatrix } from './tools/vite-gl-matrix.ts';
import { shortShaders } from './tools/vite-glsl.ts';
import { laterScripts } from './tools/vite-later-scripts.ts';
import { wasmKernel } from './tools/vite-kernel.ts';
import { withoutNodeFiles } from './tools/vite-mediabunny.ts';

/**
 * Modules that the first picture needs come in few scripts, because they take fewer requests and
 * are smaller when they are packed together. `ground` is what the page and the readers share.
 */
const firstScripts = [
  {
    name: 'ground',
    priority: 1,
    test: modules(
      'preload-helper',
      'dist/signals-core.module',
      'esm/(common|mat4)',
      'core/(assert|bounds|coordinate-hinges|diagnostics|display-boxes|failure|float32)',
      'core/(forward-kinematics|joint-transforms|limits|mesh|morph|pose|skeleton|skin)',
      'core/vertex-normals',
      'document/selected-actor',
      'skinning/(blend-matrices|method)',
      'formats/(extensions|file-entry|text/(decode-text|head-tokens|line-ends))',
    ),
  },
  {
    name: 'reading',
    test: modules(
      'app/bundled-pose',
      'core/(build-[a-z]+|coincident-joints|corner-values|equal-tuples|report-rows)',
      'core/split-corners',
      'formats/(axis-values|ball-values|json/decoder|junk|pose-json|read-characters|registry)',
      'formats/(mit|cse169|mmd)/(shape|recognize)',
      'formats/mit/(attach|human-joint-names|kinds|reader|skel)',
      'formats/obj/(continued|face-list|material-lines|plain-[a-z]+|read-mtl|read-obj)',
      'formats/obj/(resolve-index|triangulate|triangulate-faces|tuple-stream)',
      'formats/belonging/group-files',
      'formats/text/(byte-words|check-[a-z0-9]+|growable|lfs-pointer|line-[a-z]+|open-text)',
      'formats/text/(plain-numbers|read-number)',
    ),
  },
];

/** Matches modules by the ends of their paths, without extension. */
function modules(...paths: readonly string[]): RegExp {
  return new RegExp(`/(${paths.join('|')})\\.(ts|js)$`);
}

const jsx = { runtime: 'automatic', importSource: 'preact' } as const;

export default defineConfig({
  // Addresses are relative to the page, so that the built folder works at any path.
  base: './',
  // There is one page. An unknown address gives error 404 instead of the page.
  appType: 'mpa',
  plugins: [
    shortShaders(),
    wasmKernel(),
    pureGlMatrix(),
    withoutNodeFiles(),
    contentPolicy(),
    earlyRequests(),
    packedAsTheyAre(),
  ],
  oxc: { jsx },
  optimizeDeps: { entries: ['index.html'], rolldownOptions: { transform: { jsx } } },
  build: {
    target: 'es2022',
    sourcemap: false,
    modulePreload: false,
    // Small files are not inlined, because a strict content policy allows no data: addresses.
    assetsInlineLimit: 0,
    rolldownOptions: {
      output: { codeSplitting: { groups: [...firstScripts, laterScripts()] } },
      // What a part loads only when it needs it may come with the tools for the sake of another one.
      checks: { ineffectiveDynamicImport: false, bundlerTimings: false },
    },
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
