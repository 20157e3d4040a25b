import { sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { build, type Rolldown } from 'vite';
import { expect, it } from 'vitest';

const root = fileURLToPath(new URL('..', import.meta.url));

/** The page's first script, and what it imports at once. */
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

it('the first script holds what draws the first picture, and little more', async () => {
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

  // The browser measures all that comes before the first picture; this names what grew.
  expect(size, `gzipped bytes; the largest modules: ${largest.join(', ')}`).toBeLessThan(38_000);
  const later = /^src\/(cli|ui\/(panels|controls|tools)|formats\/(mit|cse169|mmd|obj|zip|json))\//;
  expect(modules.map(({ path }) => path).filter((path) => later.test(path))).toEqual([]);
  expect(modules.some(({ path }) => path === 'src/view/viewer.ts')).toBe(true);
});
