import { expect } from 'vitest';
import type { Character } from '../../../../src/core/character.ts';
import { mmdOf } from '../../../../src/formats/mmd/mmd-parts.ts';
import { noBone, pmdFile, square, squarePmd } from '../../../support/pmd-files.ts';
import { at, type BadPmd, changed, put, putCount, putFloat, warned } from './bad-pmd.ts';

/** What remains of the sections after the IK chains, in the order of the file. */
function expectSections(
  ...wanted: readonly [
    morphs: number,
    groups: number,
    english: boolean,
    toons: number,
    bodies: number,
  ]
) {
  return (character: Character): void => {
    const { display, english, toons, physics } = mmdOf(character)!;
    expect([
      ...[character.morphs.length, display.groupNames.length, english !== undefined, toons.length],
      physics?.bodies.length ?? 0,
    ]).toEqual(wanted);
  };
}

function cut(
  title: string,
  end: number,
  offset: number,
  message: string,
  check: (character: Character) => void,
): BadPmd {
  return warned(title, squarePmd.subarray(0, end), [[offset, message]], check);
}

/** Where morph 1 of the square has its first entry, and where the base has its own. */
const [base, smile] = [at.morphs + 2 + 25, at.morphs + 2 + 25 + 32 + 25];
const bodies = at.physics + 4;
const springs = bodies + 2 * 83 + 4;

/** C65 and C66: the sections after the IK chains. */
export const extraCases: readonly BadPmd[] = [
  cut(
    'C65 cut before the morphs',
    at.morphs,
    at.morphs,
    '2 bytes for the number of morphs, found "0 bytes" [pmd/truncated]',
    expectSections(0, 0, false, 0, 0),
  ),
  cut(
    'C65 cut in a morph',
    at.display - 1,
    at.display - 25,
    '25 bytes for morph 2, found "24 bytes" [pmd/truncated]',
    expectSections(0, 0, false, 0, 0),
  ),
  warned(
    'C65 four billion vertices of a morph',
    putCount(base - 5, 0xffffffff),
    [
      [
        base - 5,
        `at most ${Math.floor((squarePmd.length - base) / 16)} vertices of morph 0 of 16 bytes ` +
          `in the ${squarePmd.length - base} bytes left, found "4294967295" [pmd/count]`,
      ],
    ],
    expectSections(0, 0, false, 0, 0),
  ),
  cut(
    'C65 cut in the lists',
    at.english - 1,
    at.english - 10,
    'at most 1 listed bones of 3 bytes in the 5 bytes left, found "2" [pmd/count]',
    expectSections(2, 0, false, 0, 0),
  ),
  warned(
    'C65 a list of what is not there',
    put(at.display + 1, 3),
    [
      [
        at.display + 1,
        'lists of morphs, bones and groups that are there, found "morph 3" [pmd/index]',
      ],
    ],
    (character) => expect(mmdOf(character)!.display.morphs).toEqual([1]),
  ),
  warned(
    'C65 English names or not',
    put(at.english, 7),
    [[at.english, '0 or 1, whether there are English names, found "7" [pmd/section]']],
    expectSections(2, 2, false, 0, 0),
  ),
  cut(
    'C65 cut in the English names',
    at.toons - 1,
    at.toons - 100,
    '100 bytes for the English names of groups, found "99 bytes" [pmd/truncated]',
    expectSections(2, 2, false, 0, 0),
  ),
  cut(
    'C65 cut in the toons',
    at.physics - 1,
    at.toons,
    '1000 bytes for the names of toon textures, found "999 bytes" [pmd/truncated]',
    expectSections(2, 2, true, 0, 0),
  ),
  cut(
    'C65 cut in the physics',
    at.end - 1,
    springs - 4,
    'at most 0 joints of rigid bodies of 124 bytes in the 123 bytes left, found "1" [pmd/count]',
    expectSections(2, 2, true, 10, 0),
  ),
  warned('C65 ends after the lists', pmdFile({ ...square, last: 'display' }).bytes, []),
  warned('C65 ends after the English names', pmdFile({ ...square, last: 'english' }).bytes, []),
  warned(
    'C65 ends after the toons',
    pmdFile({ ...square, last: 'toons' }).bytes,
    [],
    expectSections(2, 2, true, 10, 0),
  ),
  warned(
    'C65 something after its end',
    Uint8Array.of(...squarePmd, 1, 2, 3),
    [[at.end, 'the end of the file, found "3 more bytes" [pmd/trailing]']],
    expectSections(2, 2, true, 10, 2),
  ),
  warned(
    'C66 a vertex of the base past the end',
    putCount(base, 4),
    [[base, 'morphs of vertices that are there, by numbers, found "4, morph base" [pmd/index]']],
    ({ morphs }) => expect([...morphs[0]!.parts.points]).toEqual([1]),
  ),
  warned(
    'C66 a vertex of a morph past the end of the base',
    putCount(smile, 2),
    [
      [
        smile,
        'morphs of vertices that are there, by numbers, found "2, morph "smile"" [pmd/index]',
      ],
    ],
    ({ morphs }) => expect(morphs[0]!.parts.points).toHaveLength(0),
  ),
  warned('C66 NaN offset', putFloat(smile + 4, NaN), [
    [
      smile,
      'morphs of vertices that are there, by numbers, found "NaN 0.25 0.125, morph "smile"" [pmd/index]',
    ],
  ]),
  {
    ...warned('C66 no base', changed({ morphs: square.morphs!.slice(1) }), []),
    messages: [
      'warning: a.pmd: expected a base morph, found "none" [pmd/section]',
      `warning: a.pmd @ byte ${at.display - 56} (0x${(at.display - 56).toString(16)}): expected ` +
        'lists of morphs, bones and groups that are there, found "morph 2" [pmd/index]',
    ],
    check: ({ morphs }) => expect(morphs).toEqual([]),
  },
  warned(
    'C66 a body of a bone past the end',
    put(bodies + 20, 4, 0),
    [
      [
        bodies + 20,
        'rigid bodies and joints by numbers, of bones and bodies that are there, ' +
          'found "bone 4, body 0" [pmd/index]',
      ],
    ],
    (character) => expect(mmdOf(character)!.physics!.bodies[0]!.bone).toBe(-1),
  ),
  warned(
    'C66 a body of no bone',
    changed({ bodies: [{ bone: noBone }, { bone: 0 }] }),
    [],
    (character) =>
      expect(mmdOf(character)!.physics!.bodies.map(({ bone }) => bone)).toEqual([-1, 0]),
  ),
  warned(
    'C66 a joint to a body that is not there',
    putCount(springs + 24, 2),
    [
      [
        springs + 20,
        'rigid bodies and joints by numbers, of bones and bodies that are there, ' +
          'found "body 2, joint 0" [pmd/index]',
      ],
    ],
    (character) => expect(mmdOf(character)!.physics!.joints).toEqual([]),
  ),
];
