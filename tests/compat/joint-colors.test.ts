import { readdirSync } from 'node:fs';
import { expect, it } from 'vitest';
import { leastDifference, readRight } from '../support/color-judges.ts';
import { type FileContents, readContents } from '../support/files.ts';
import {
  describeWithShared,
  modelFiles,
  sharedBytes,
  sharedFiles,
  sharedPath,
} from './shared-material.ts';

const [mit, cse169, pmd] = ['data/mit-6837', 'data/cse169', 'data/pmd/KAITO.pmd'];

describeWithShared('the colors of joints of real characters', [mit, cse169, pmd], () => {
  const read: Readonly<Record<string, () => FileContents>> = {
    '6.837': () => modelFiles('Model1'),
    CSE169: () => sharedFiles(cse169, ...readdirSync(sharedPath(cse169))),
    'the Virtual Mannequin': () => ({ 'KAITO.pmd': sharedBytes(pmd) }),
  };

  it.each(Object.keys(read))('differ, and vertices are read right, in files of %s', async (id) => {
    const { characters } = await readContents(read[id]!());
    const colored = characters.filter(({ character }) => character.skeleton.jointCount > 0);
    const right = colored.flatMap(({ character }) => {
      expect(leastDifference(character.skeleton), character.name).toBeGreaterThanOrEqual(10);
      // Some of CSE169 have too little skin that one joint owns.
      return readRight(character) ?? [];
    });
    expect(Math.min(...right)).toBeGreaterThanOrEqual(18);
    expect(right.length).toBeGreaterThan(0);
  });
});
