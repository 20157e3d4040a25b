import { defineConfig } from 'vite';
import { sourcesHash } from './tools/sources-hash.mjs';
import { pureGlMatrix } from './tools/vite-gl-matrix.ts';

/**
 * Bundles the command line into one file that needs only Node. It starts at once, where running
 * the sources translates every module first.
 */
export default defineConfig({
  plugins: [pureGlMatrix()],
  publicDir: false,
  ssr: { noExternal: true },
  build: {
    ssr: 'src/cli/main.ts',
    outDir: 'build',
    target: 'node20',
    rolldownOptions: {
      output: {
        entryFileNames: 'sinew.mjs',
        codeSplitting: false,
        banner: () => `#!/usr/bin/env node\n// Sources: ${sourcesHash()}`,
      },
    },
  },
});
