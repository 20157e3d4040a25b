import { expect } from 'vitest';
import { axisDofs } from '../../../../src/core/pose.ts';
import type { Character } from '../../../../src/core/character.ts';
import { DofKind } from '../../../../src/core/skeleton.ts';
import { type BadInput, noSkel, readSkeleton } from './bad-input.ts';

/** A joint with this property, which starts at the fifteenth byte of the line. */
const joint = (property: string): string => `balljoint a { ${property} }`;

/** Angle, minimum and maximum of the hinges about x, y and z of the first joint. */
function hingesOf({ skeleton }: Character): number[][] {
  return axisDofs(skeleton, 0)
    .filter(({ kind }) => kind === DofKind.hinge)
    .toSorted((a, b) => a.axis - b.axis)
    .map(({ index }) => [skeleton.qRest[index]!, skeleton.qMin[index]!, skeleton.qMax[index]!]);
}

const free = [0, -Infinity, Infinity];
const boxOf = ({ skeleton }: Character): number[] => [...(skeleton.displayBoxes ?? [])];

function badNumber(title: string, number: string): BadInput {
  const message = `:1:22: expected a number for offset x, found "${number}" [skel/number]`;
  return noSkel(title, joint(`offset ${number} 0 0`), message);
}

/** B10 to B12, B15 to B24, B29, B33 and B35: offsets, boxes, limits and poses. */
export const skelValues: readonly BadInput[] = [
  noSkel(
    'B10 two numbers of three',
    'balljoint a {\n offset 1 2\n pose 0 0 0 }',
    ':3:2: expected a number for offset z, found "pose" [skel/number]',
  ),
  badNumber('B11 words for numbers', 'a'),
  noSkel(
    'B11 a decimal comma',
    joint('offset 0,5 0 0'),
    ':1:22: expected a number for offset x with a decimal point, found "0,5" [skel/number]',
  ),
  readSkeleton(
    'B12 a property twice',
    joint('offset 1 2 3 offset 4 5 6 offset 7 8 9'),
    [':1:28: expected one "offset" a joint, found "another" [skel/duplicate]; the last one counts'],
    1,
    ({ skeleton }) => expect([...skeleton.restOffsets]).toEqual([7, 8, 9]),
  ),
  readSkeleton(
    'B15 a box with min above max',
    joint('boxmin 1 0 0 boxmax 0 1 1'),
    [
      ':1:15: expected boxmin of "a" below its boxmax, found "1 0 0 and 0 1 1" [skel/box]; ' +
        'they are swapped where they are not',
    ],
    1,
    (character) => expect(boxOf(character)).toEqual([0, 0, 0, 1, 1, 1]),
  ),
  readSkeleton('B16 a box of no size', joint('boxmin 1 1 1 boxmax 1 1 1'), [], 1, (character) =>
    expect(boxOf(character)).toEqual([1, 1, 1, 1, 1, 1]),
  ),
  noSkel(
    'B17 a box past what can be drawn',
    joint('boxmax 1 1e30 1'),
    ':1:24: expected boxmax y within ±1e18, found "1e30" [skel/range]',
  ),
  {
    ...noSkel(
      'B17 an offset past a smaller limit',
      joint('offset 0 0 -101'),
      ':1:26: expected offset z within ±1e2, found "-101" [skel/range]',
    ),
    limits: { coordinate: 100 },
  },
  noSkel(
    'B18 a box of NaN',
    joint('boxmax NaN 1 1'),
    ':1:22: expected a number for boxmax x, found "NaN" [skel/number]',
  ),
  readSkeleton(
    'B19 limits with min above max',
    joint('rotxlimit 1 -1'),
    [':1:27: expected rotxlimit with min below max, found "1 -1" [skel/limits]; they are swapped'],
    1,
    (character) => expect(hingesOf(character)).toEqual([[0, -1, 1], free, free]),
  ),
  readSkeleton('B20 min = max', joint('rotylimit 0.5 0.5 pose 0 0.5 0'), [], 1, (character) =>
    expect(hingesOf(character)).toEqual([free, [0.5, 0.5, 0.5], free]),
  ),
  noSkel(
    'B21 one limit of two',
    joint('rotxlimit 5'),
    ':1:27: expected a number for rotxlimit max, found "}" [skel/number]',
  ),
  readSkeleton(
    'B22 limits so wide that they are none',
    joint('rotzlimit -100000 100000'),
    [],
    1,
    (character) => expect(hingesOf(character)).toEqual([free, free, [0, -100_000, 100_000]]),
  ),
  readSkeleton(
    'B23 a pose outside of its limits',
    joint('rotxlimit -2 0 rotylimit 0 0 rotzlimit 0 0 pose -3 1 2'),
    [
      ':1:58: expected pose x of "a" within its limits, -2 to 0, found "-3" [skel/range]; it is clamped to -2',
      ':1:58: expected pose y of "a" within its limits, 0 to 0, found "1" [skel/range]; it is clamped to 0',
      ':1:58: expected pose z of "a" within its limits, 0 to 0, found "2" [skel/range]; it is clamped to 0',
    ],
    1,
    (character) =>
      expect(hingesOf(character)).toEqual([
        [-2, -2, 0],
        [0, 0, 0],
        [0, 0, 0],
      ]),
  ),
  readSkeleton(
    'B23 limits that leave out the pose that is not given',
    joint('\nrotxlimit 1 2\nrotylimit -1 1\n'),
    [
      ':2:1: expected pose x of "a" within its limits, 1 to 2, found "0" [skel/range]; it is clamped to 1',
    ],
    1,
    (character) => expect(hingesOf(character)).toEqual([[1, 1, 2], [0, -1, 1], free]),
  ),
  readSkeleton(
    'B24 a pose in degrees',
    joint('pose 90 0 0'),
    [
      ':1:15: expected angles in radians for "a", found "90 0 0" [skel/degrees]; ' +
        'they are used as radians, more than a full turn',
    ],
    1,
    (character) => expect(hingesOf(character)[0]![0]).toBe(90),
  ),
  readSkeleton('B29 nothing but a name', 'balljoint r {}', [], 1, (character) => {
    expect([...character.skeleton.restOffsets]).toEqual([0, 0, 0]);
    boxOf(character).forEach((value, i) => expect(value).toBeCloseTo(i < 3 ? -0.1 : 0.1, 6));
    expect(hingesOf(character)).toEqual([free, free, free]);
  }),
  badNumber('B33 NaN as Windows prints it', '1.#QNAN'),
  noSkel(
    'B33 an indefinite number as Windows prints it',
    joint('offset 0 -1.#IND 0'),
    ':1:24: expected a number for offset y, found "-1.#IND" [skel/number]',
  ),
  readSkeleton(
    'B35 a number as long as may be',
    joint(`offset ${'1'.padStart(64, '0')} 0 0`),
    [],
    1,
  ),
  noSkel(
    'B35 a number of 65 characters',
    joint(`offset ${'1'.padStart(65, '0')} 0 0`),
    `:1:22: expected a number of at most 64 characters for offset x, found "${'0'.repeat(40)}…" [skel/token]`,
  ),
  noSkel(
    'B35 a number of 100,000 digits',
    joint(`pose 0 ${'1'.repeat(100_000)} 0`),
    `:1:22: expected a number of at most 64 characters for pose y, found "${'1'.repeat(40)}…" [skel/token]`,
  ),
];
