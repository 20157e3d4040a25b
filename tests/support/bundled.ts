import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gunzipSync } from 'node:zlib';
import type { Catalogue } from '../../src/app/catalogue.ts';
import type { Character } from '../../src/core/character.ts';
import type { Parsed } from '../../src/core/diagnostics.ts';
import type { ClipParts } from '../../src/core/motion/clip-parts.ts';
import { readBoundMotion } from '../../src/formats/motion/read-bound-motion.ts';
import { readOne } from './files.ts';

const folder = join(import.meta.dirname, '../../public/data');

export const catalogue = JSON.parse(
  readFileSync(join(folder, 'catalogue.json'), 'utf8'),
) as Catalogue;

export const bundledIds: readonly string[] = catalogue.characters.map(({ id }) => id);

/** Characters do not change, so each is read once in a process. */
const known = new Map<string, Promise<Character>>();

/** Reads a bundled character as the page does, without its motions. */
export function readBundled(id: string): Promise<Character> {
  let character = known.get(id);
  if (!character) known.set(id, (character = read(id)));
  return character;
}

function read(id: string): Promise<Character> {
  const { files } = catalogue.characters.find((entry) => entry.id === id)!;
  const contents = files.map((file) => {
    const bytes = readFileSync(join(folder, file));
    return [file.replace(/\.gz$/, ''), file.endsWith('.gz') ? gunzipSync(bytes) : bytes] as const;
  });
  return readOne(Object.fromEntries(contents));
}

/** Reads the motions of a bundled character as the page does. */
export function readMotionsOf(id: string, character: Character): readonly Parsed<ClipParts>[] {
  const { motions = [] } = catalogue.characters.find((entry) => entry.id === id)!;
  return motions.map((path) => readBoundMotion(path, readFileSync(join(folder, path)), character));
}
