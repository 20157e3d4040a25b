import path from 'node:path';
import { build } from 'vite';
import { cacheFolder, root } from '../../tools/commands.mjs';
import { pureGlMatrix } from '../../tools/vite-gl-matrix.ts';
import { shortShaders } from '../../tools/vite-glsl.ts';

/**
 * Bundles scripts of bench/ for bare pages, as the product is bundled.
 *
 * @param scripts the files, by the names of their pages
 * @returns the folder to serve
 */
export async function buildPages(
  name: string,
  scripts: Readonly<Record<string, string>>,
): Promise<string> {
  const folder = path.join(cacheFolder, 'bench', name);
  await build({
    root: path.join(root, 'bench'),
    configFile: false,
    logLevel: 'warn',
    base: './',
    publicDir: false,
    plugins: [shortShaders(), pureGlMatrix()],
    build: {
      target: 'es2022',
      outDir: folder,
      emptyOutDir: true,
      modulePreload: false,
      chunkSizeWarningLimit: 2000,
      rolldownOptions: {
        input: Object.fromEntries(
          Object.entries(scripts).map(([page, file]) => [page, path.join(root, 'bench', file)]),
        ),
        output: { entryFileNames: '[name].js' },
      },
    },
  });
  return folder;
}
