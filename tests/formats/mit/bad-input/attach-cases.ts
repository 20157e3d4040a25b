import { expect } from 'vitest';
import type { Character } from '../../../../src/core/character.ts';
import { all, type BadInput, unbound, whole, withAttach } from './bad-input.ts';

function refused(title: string, text: string, ...faults: string[]): BadInput {
  const messages = faults.map((fault) => `error: a.attach${fault}`);
  return { title, files: withAttach(text), messages, left: unbound };
}

function warned(
  title: string,
  text: string,
  message: string,
  check: (character: Character) => void,
): BadInput {
  return {
    title,
    files: withAttach(text),
    messages: [`warning: a.attach${message}`],
    left: all,
    check,
  };
}

/** A point's row: file index of each joint, and its weight. */
function rowOf({ skeleton, skin }: Character, point: number): number[][] {
  return Array.from(skin.entries.subarray(skin.start[point], skin.start[point + 1]), (entry, i) => [
    skeleton.sourceIndex[skin.paletteJoint[entry]!]!,
    skin.weights[skin.start[point]! + i]!,
  ]);
}

const rows = 'one for each vertex of a.obj, found';
const columns = 'expected 2 weights (3 joints in a.skel, less the root), found';
const sums = 'expected weights that sum to 1 for every vertex, found';
const twelve = Array.from({ length: 12 }, (_, i) => 2 ** -Math.min(i + 1, 11));

/** A56 to A66: the weights. */
export const attachCases: readonly BadInput[] = [
  refused('A56 empty file', '', ': expected .attach text, found "an empty file" [file/empty]'),
  refused('A56 only blanks', '\n \n', ': expected a row a vertex, found "no row" [attach/empty]'),
  refused(
    'A57 a row too few',
    '1 0\n1 0\n1 0\n',
    `: expected 4 rows of weights, ${rows} "3 rows" [character/count]`,
  ),
  refused(
    'A57 a row too many',
    '1 0\n'.repeat(5),
    `: expected 4 rows of weights, ${rows} "5 rows" [character/count]`,
  ),
  refused(
    'A58 a column for the root',
    '0 1 0\n'.repeat(4),
    `:1: ${columns} "3" [attach/field-count]`,
  ),
  refused('A58 a column too few', '1\n'.repeat(4), `:1: ${columns} "1" [attach/field-count]`),
  refused(
    'A59 ragged rows',
    '1 0\n1 0 0\n1\n1 0\n',
    `:2: ${columns} "3" [attach/field-count]`,
    `:3: ${columns} "1" [attach/field-count]`,
  ),
  warned(
    'A60 negative weight',
    '1.5 -0.5\n1 0\n1 0\n1 0\n',
    ':1: expected weights of at least 0, found "negative ones for 1: vertex 1" ' +
      '[character/weight-negative]',
    (character) =>
      expect(rowOf(character, 0)).toEqual([
        [1, 1.5],
        [2, -0.5],
      ]),
  ),
  refused(
    'A60 nan',
    '1 0\n1 nan\n1 0\n1 0\n',
    ':2:3: expected a number for weight 2, found "nan" [attach/number]',
  ),
  warned(
    'A61 row of zeros',
    '1 0\n0 0\n1 0\n0 1e-7\n',
    ':2: expected at least one weight for every vertex, found "none for 2: vertex 2, 4" ' +
      '[character/weight-zero]',
    (character) =>
      expect([1, 3].map((point) => rowOf(character, point))).toEqual([[[0, 1]], [[0, 1]]]),
  ),
  warned(
    'A62 sums of 0.98 and 2',
    '0.98 0\n1 1\n1 0\n1 0\n',
    `:2: ${sums} "0.98 to 2 for 2" [character/weight-sum]`,
    (character) =>
      expect([0, 1].map((point) => rowOf(character, point))).toEqual([
        [[1, Math.fround(0.98)]],
        [
          [1, 1],
          [2, 1],
        ],
      ]),
  ),
  refused(
    'A63 weights whose sum is beyond float32',
    '1e38 1e38\n1 0\n1 0\n1 0\n',
    ':1:1: expected weight 1 within ±1e6, found "1e38" [attach/range]',
    ':1:6: expected weight 2 within ±1e6, found "1e38" [attach/range]',
  ),
  {
    title: 'A64 twelve influences',
    files: {
      ...whole,
      'a.skel': `0 0 0 -1\n${'0 1 0 0\n'.repeat(12)}`,
      'a.attach': `${twelve.join(' ')}\n`.repeat(4),
    },
    messages: [],
    left: { ...all, joints: 13 },
    check: (character) => expect(rowOf(character, 3).map(([, weight]) => weight)).toEqual(twelve),
  },
  refused(
    'A65 blank line between rows',
    '1 0\n\n0 1\n1 0\n1 0\n',
    ':2: expected a row of weights for every vertex, found "a blank line" [attach/count]',
  ),
  {
    title: 'A65 blank lines after the last row, comments anywhere',
    files: withAttach('# weights\n1 0\n1 0 # two\n# more\n0 1\n1 0\n\n \n'),
    messages: [],
    left: all,
  },
  refused(
    'A66 weights of another model, with as many vertices',
    '0.5 0.25 0.25\n'.repeat(4),
    `:1: ${columns} "3" [attach/field-count]`,
  ),
  {
    title: 'A66 weights under another name',
    files: {
      'a.skel': whole['a.skel']!,
      'a.obj': whole['a.obj']!,
      'b.attach': whole['a.attach']!,
    },
    messages: [
      'warning: a.skel: expected files of one name in one folder, found "a.obj, b.attach" [file/pairing]',
    ],
    left: all,
  },
  {
    title: 'A66 all three under different names',
    files: {
      'c.attach': whole['a.attach']!,
      'a.skel': whole['a.skel']!,
      'b.obj': whole['a.obj']!,
    },
    messages: [
      'warning: a.skel: expected files of one name in one folder, found "b.obj, c.attach" [file/pairing]',
    ],
    left: all,
  },
];
