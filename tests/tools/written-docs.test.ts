import { readFileSync } from 'node:fs';
import path from 'node:path';
import { expect, test } from 'vitest';
import { root } from '../../tools/commands.mjs';
import { writtenPages } from '../../tools/write-docs.ts';

test('the pages made from tables are what the tables give; `npm run docs` writes them', async () => {
  for (const { file, text } of await writtenPages()) {
    expect(readFileSync(path.join(root, file), 'utf8'), file).toBe(text);
  }
});
