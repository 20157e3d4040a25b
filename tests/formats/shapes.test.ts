import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { largestInfluenceCount } from '../../src/core/skin.ts';
import { fitsShape } from '../../src/formats/fits-shape.ts';
import { formats } from '../../src/formats/registry.ts';
import { readOne } from '../support/files.ts';
import { formatSamples } from './samples.ts';

// Taken from the registry, so that no format can be forgotten.
describe.each(formats)('the shape of $id', ({ id, shape }) => {
  it.each(Object.entries(formatSamples[id]!.characters))(
    'holds what its reader gives: %s',
    async (_, files) => {
      const character = await readOne(files);
      const { skeleton, skin, meta, materials, morphs, clips } = character;
      expect(fitsShape(character, shape)).toBe(true);
      expect(meta.fileSpace).toBe(shape.handedness);
      expect(largestInfluenceCount(skin)).toBeLessThanOrEqual(shape.influences);
      const found = {
        limits: [...skeleton.qMin].some((low) => low > -Infinity),
        jointNames: skeleton.fileNames.some((name) => name !== ''),
        jointBoxes: Boolean(skeleton.displayBoxes),
        textures: materials.some(({ texture }) => texture !== undefined),
        colors: materials.some(({ colors }) => colors !== undefined),
        morphs: morphs.length > 0,
        clips: clips.length > 0,
      };
      for (const [part, isThere] of Object.entries(found)) {
        if (isThere)
          expect([part, Boolean(shape[part as keyof typeof found])]).toEqual([part, true]);
      }
    },
  );

  it('is not that of another format', async () => {
    const others = formats.filter((other) => other.id !== id);
    for (const other of others) {
      const [files] = Object.values(formatSamples[other.id]!.characters);
      expect([other.id, fitsShape(await readOne(files!), shape)]).toEqual([other.id, false]);
    }
  });
});

describe('names of formats', () => {
  const names = formats.map(({ id }) => id).join('|');
  const comparison = new RegExp(
    `[!=]==?\\s*['"\`](${names})['"\`]|['"\`](${names})['"\`]\\s*[!=]==?|case ['"\`](${names})['"\`]`,
  );

  it('are recognized where they are compared', () => {
    expect("to === 'mit'").toMatch(comparison);
    expect("case 'cse169':").toMatch(comparison);
    expect("id: 'mmd'").not.toMatch(comparison);
  });

  it('are compared nowhere outside the folder of a format', () => {
    const source = join(import.meta.dirname, '../../src');
    const own = formats.map(({ id }) => join('formats', id, '/'));
    const files = readdirSync(source, { recursive: true, encoding: 'utf8' }).filter(
      (path) => /\.tsx?$/.test(path) && !own.some((folder) => path.startsWith(folder)),
    );
    expect(files.length).toBeGreaterThan(100);
    const found = files.filter((path) => comparison.test(readFileSync(join(source, path), 'utf8')));
    expect(found).toEqual([]);
  });
});
