import { readFileSync } from 'node:fs';
import path from 'node:path';
import { expect, test } from 'vitest';
import { root } from '../../tools/commands.mjs';
import { writtenPages } from '../../tools/write-docs.ts';

test('the pages that `npm run docs` generates are up to date with their tables', async () => {
  for (const { file, text } of await writtenPages()) {
    expect(readFileSync(path.join(root, file), 'utf8'), file).toBe(text);
  }
});
