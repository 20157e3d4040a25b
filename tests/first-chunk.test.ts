import { sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { build, type Rolldown } from 'vite';
import { expect, it } from 'vitest';

const root = fileURLToPath(new URL('..', import.meta.url));

/** Returns the page's first script and the scripts that it imports statically. */
async function firstChunks(): Promise<readonly Rolldown.OutputChunk[]> {
  const { output } = (await build({
    root,
    logLevel: 'silent',
    build: { write: false },
  })) as Rolldown.RolldownOutput;
  const chunks = output.filter((each) => each.type === 'chunk');
  const first = new Set(chunks.filter(({ isEntry }) => isEntry));
  for (const { imports } of first) {
    for (const chunk of chunks) if (imports.includes(chunk.fileName)) first.add(chunk);
  }
  return [...first];
}

it('the first script contains what draws the first picture, and little more', async () => {
  const chunks = await firstChunks();
  const modules = chunks
    .flatMap((chunk) => Object.entries(chunk.modules))
    .map(([id, { renderedLength }]) => ({
      path: id.replace(root, '').split(sep).join('/'),
      bytes: renderedLength,
    }))
    .sort((a, b) => b.bytes - a.bytes);
  const largest = modules.slice(0, 5).map(({ path, bytes }) => `${path} ${bytes}`);
  const size = chunks.reduce((sum, { code }) => sum + gzipSync(code, { level: 9 }).length, 0);

  // The browser test measures everything that is loaded before the first picture; this test names
  // the module that grew. What the page shares with the readers is among these scripts.
  expect(size, `gzipped bytes; the largest modules: ${largest.join(', ')}`).toBeLessThan(42_500);
  const later = /^src\/(cli|ui\/(panels|controls|tools)|formats\/(mit|cse169|mmd|obj|zip|json))\//;
  expect(modules.map(({ path }) => path).filter((path) => later.test(path))).toEqual([]);
  expect(modules.some(({ path }) => path === 'src/view/viewer.ts')).toBe(true);
});
