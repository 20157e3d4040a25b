import { defineConfig, type Plugin } from 'vite';
import { compileKernel } from './tools/compile-kernel.ts';
import { sourcesHash } from './tools/sources-hash.mjs';
import { pureGlMatrix } from './tools/vite-gl-matrix.ts';

/**
 * Bundles the command line into one file that needs only Node. It starts at once, where running
 * the sources translates every module first.
 */
export default defineConfig({
  plugins: [embeddedKernel(), pureGlMatrix()],
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

/** Puts the compiled kernel in the place of its compiler, which a single file does not have. */
function embeddedKernel(): Plugin {
  return {
    name: 'embedded-kernel',
    enforce: 'pre',
    async load(id) {
      if (!id.endsWith('/tools/compile-kernel.ts')) return null;
      const text = Buffer.from(await compileKernel()).toString('base64');
      return `export const compileKernel = async () => new Uint8Array(Buffer.from('${text}', 'base64'));`;
    },
  };
}
