import type { Plugin } from 'vite';
import { compileKernel, kernelFile } from './compile-kernel.ts';

const served = '/skinning-kernel.wasm';

/**
 * Makes `import address from '…/kernel.as?url'` the address of the compiled kernel: a file of the
 * build, or one that the dev server compiles when it is requested.
 */
export function wasmKernel(): Plugin {
  let isBuild = false;
  return {
    name: 'wasm-kernel',
    enforce: 'pre',
    configResolved: ({ command }) => void (isBuild = command === 'build'),
    async load(id) {
      if (id !== `${kernelFile}?url`) return null;
      if (!isBuild) return `export default ${JSON.stringify(served)};`;
      this.addWatchFile(kernelFile);
      const source = await compileKernel();
      const file = this.emitFile({ type: 'asset', name: 'skinning-kernel.wasm', source });
      return `export default import.meta.ROLLUP_FILE_URL_${file};`;
    },
    configureServer: ({ middlewares }) =>
      void middlewares.use(served, (_, response, next) => {
        compileKernel().then((bytes) => {
          response.setHeader('Content-Type', 'application/wasm');
          response.end(bytes);
        }, next);
      }),
  };
}
