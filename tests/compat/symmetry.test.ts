import { expect, it } from 'vitest';
import type { Character } from '../../src/core/character.ts';
import type { Skeleton } from '../../src/core/skeleton.ts';
import { jointPairs, noPartner } from '../../src/posing/symmetry/joint-pairs.ts';
import { mirrorJoints, symmetryOf } from '../../src/posing/symmetry/symmetry.ts';
import { largestPairOffset, randomPose } from '../posing/symmetry/mirror-laws.ts';
import { readContents } from '../support/files.ts';
import { tolerances } from '../tolerances.ts';
import { describeWithShared, modelFiles, sharedFiles } from './shared-material.ts';

type Counts = readonly [pairs: number, center: number, alone: number];

const kaito = () => sharedFiles('data/pmd', 'KAITO.pmd');
const wasp = () => sharedFiles('data/cse169', 'wasp_old.skel', 'wasp_old.skin');
const dragon = () => sharedFiles('data/cse169', 'dragon.skel');

async function read(files: Parameters<typeof readContents>[0]): Promise<Character> {
  return (await readContents(files)).characters[0]!.character;
}

function counts({ parents }: Skeleton, { partners, sides }: ReturnType<typeof jointPairs>): Counts {
  const joints = Array.from(parents.keys());
  return [
    joints.filter((joint) => sides[joint] === 1).length,
    joints.filter((joint) => partners[joint] === joint).length,
    joints.filter((joint) => partners[joint] === noPartner).length,
  ];
}

describeWithShared('the pairs of the courses’ own characters', ['data'], () => {
  it.each<readonly [string, () => Parameters<typeof readContents>[0], Counts]>([
    ['Model1', () => modelFiles('Model1'), [7, 4, 0]],
    ['KAITO', kaito, [44, 13, 5]],
    ['the wasp', wasp, [8, 7, 0]],
    ['the dragon', dragon, [28, 25, 0]],
  ])('are found: %s', async (_, files, expected) => {
    const { skeleton } = await read(files());
    const pairs = jointPairs(skeleton);
    expect(counts(skeleton, pairs)).toEqual(expected);
    pairs.partners.forEach((partner, joint) => {
      if (pairs.sides[joint] !== 1) return;
      const right = skeleton.names[joint]!.replace('Left', 'Right').replace('左', '右');
      const other = right.replace('left', 'right').replace(/_l$/, '_r');
      expect(skeleton.names[partner]).toBe(other);
    });
  });

  it('tells who has no partner: the hair of KAITO', async () => {
    const { skeleton } = await read(kaito());
    const { partners } = jointPairs(skeleton);
    const alone = skeleton.names.filter((_, joint) => partners[joint] === noPartner);
    expect(alone).toEqual(['前髪３', '前髪３先', '前髪１', '前髪１先', '後髪先']);
  });

  it('stand apart at zero where the pose of the file is not symmetrical', async () => {
    const { skeleton } = await read(dragon());
    expect([...jointPairs(skeleton).reference].every((value) => value === 0)).toBe(true);
  });
});

describeWithShared('a mirrored pose of the courses’ own characters', ['data'], () => {
  it.each([
    ['KAITO', kaito],
    ['the wasp', wasp],
  ])('has mirrored joints, and is undone by mirroring: %s', async (_, files) => {
    const { skeleton } = await read(files());
    const symmetry = symmetryOf(skeleton);
    const all = Array.from(skeleton.parents.keys());
    const q = randomPose(skeleton, 5);
    const { q: image, alone } = mirrorJoints(symmetry, q, q, all);
    expect(mirrorJoints(symmetry, image, image, all).q).toEqual(q);
    // Hair and scarf are not symmetrical themselves.
    const symmetric = all.filter((j) => !alone.includes(j) && !/髪|ﾏﾌﾗｰ/.test(skeleton.names[j]!));
    expect(largestPairOffset(symmetry, q, image, symmetric)).toBeLessThan(tolerances.mirrored);
  });
});
