import { existsSync } from 'node:fs';
import path from 'node:path';
import { expect, it } from 'vitest';
import { formats } from '../../../src/formats/registry.ts';

it.each(formats)('there is garbage for $id', ({ id }) => {
  expect(existsSync(path.join(import.meta.dirname, `${id}.test.ts`))).toBe(true);
});
