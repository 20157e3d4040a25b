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
        input: inputOf(scripts),
        output: { entryFileNames: '[name].js' },
      },
    },
  });
  return folder;
}

/**
 * Bundles programs of bench/ for Node, so that a process holds its code and nothing that compiles it.
 *
 * @returns the programs' files by their names
 */
export async function buildPrograms(
  name: string,
  scripts: Readonly<Record<string, string>>,
): Promise<Readonly<Record<string, string>>> {
  const folder = path.join(cacheFolder, 'bench', name);
  await build({
    root: path.join(root, 'bench'),
    configFile: false,
    logLevel: 'warn',
    publicDir: false,
    ssr: { noExternal: true },
    build: {
      ssr: true,
      target: 'node20',
      outDir: folder,
      emptyOutDir: true,
      rolldownOptions: { input: inputOf(scripts), output: { entryFileNames: '[name].mjs' } },
    },
  });
  return Object.fromEntries(
    Object.keys(scripts).map((program) => [program, path.join(folder, `${program}.mjs`)]),
  );
}

function inputOf(scripts: Readonly<Record<string, string>>): Record<string, string> {
  return Object.fromEntries(
    Object.entries(scripts).map(([page, file]) => [page, path.join(root, 'bench', file)]),
  );
}

/** Builds the product into a folder of the bench, so that the served build is never an older one. */
export async function buildApp(): Promise<string> {
  const folder = path.join(cacheFolder, 'bench/app');
  await build({ root, logLevel: 'warn', build: { outDir: folder, emptyOutDir: true } });
  return folder;
}
