import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gunzipSync } from 'node:zlib';
import type { Catalogue } from '../../src/app/catalogue.ts';
import type { Character } from '../../src/core/character.ts';
import { readOne } from './files.ts';

const folder = join(import.meta.dirname, '../../public/data');

export const catalogue = JSON.parse(
  readFileSync(join(folder, 'catalogue.json'), 'utf8'),
) as Catalogue;

export const bundledIds: readonly string[] = catalogue.characters.map(({ id }) => id);

/** Reads a bundled character as the page does. */
export function readBundled(id: string): Promise<Character> {
  const { files } = catalogue.characters.find((entry) => entry.id === id)!;
  const contents = files.map((file) => {
    const bytes = readFileSync(join(folder, file));
    return [file.replace(/\.gz$/, ''), file.endsWith('.gz') ? gunzipSync(bytes) : bytes] as const;
  });
  return readOne(Object.fromEntries(contents));
}
