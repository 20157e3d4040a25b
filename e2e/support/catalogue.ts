import { readFileSync } from 'node:fs';
import path from 'node:path';
import type { Catalogue } from '../../src/app/catalogue.ts';

/** The bundled characters and scenes, as the built app lists them. */
export const { characters: catalogue, scenes } = JSON.parse(
  readFileSync(path.resolve(import.meta.dirname, '../../dist/data/catalogue.json'), 'utf8'),
) as Catalogue;
