import { expect } from 'vitest';
import { type BadInput, noSkin, readSkinOf, skinText, unbound, whole } from './bad-input.ts';

/** Rows of weights that start at the seventeenth byte of the third line. */
const weights = (rows: string, count = 3): string =>
  skinText({ skinweights: `skinweights ${count} { ${rows} }` });

/** Bindings whose first element starts at the twenty-third byte of the fifth line. */
const matrix = (elements: string): string =>
  skinText({ bindings: `bindings 1 { matrix { ${elements} } }` });

/** B50 to B57 and B60 to B64, B66: weights and bindings. */
export const skinWeights: readonly BadInput[] = [
  noSkin(
    'B50 fewer rows than positions',
    weights('1 0 1 1 0 1', 2),
    ': expected 3 rows of skinweights, one for each position, found "2" [skin/count]',
  ),
  readSkinOf('B51 a vertex without influences', weights('1 0 1 0 1 0 1'), [
    ':3: expected at least one weight for every vertex, found "none for 1: vertex 2" [character/weight-zero]; they follow the root rigidly',
  ]),
  noSkin(
    'B52 -1 influences',
    weights('-1 0 1 1 0 1 1 0 1'),
    ':3:17: expected how many influences of vertex 0, a whole number, found "-1" [skin/integer]',
  ),
  noSkin(
    'B52 a thousand million influences',
    weights('1000000000 0 1'),
    ':3:17: expected at most 19 influences of vertex 0, for the file has no room for more, found "1000000000" [skin/count]',
  ),
  noSkin(
    'B53 a joint without binding',
    weights('1 0 1 1 0 1 1 23 1'),
    ':3: expected joints from 0 to 0, for which there are bindings, found "23, vertex 2" [skin/index]',
  ),
  noSkin(
    'B53 a joint past any',
    weights('1 4096 1 1 0 1 1 0 1'),
    ':3:19: expected a joint of vertex 0 from 0 to 4095, found "4096" [skin/index]',
  ),
  noSkin(
    'B54 a negative joint',
    weights('1 -1 1 1 0 1 1 0 1'),
    ':3:19: expected a whole number for a joint of vertex 0, 0 or more, found "-1" [skin/integer]',
  ),
  readSkinOf(
    'B55 a joint twice',
    weights('2 0 .25 0 .75 1 0 1 2 0 .5 0 .5'),
    [
      ':3:25: expected each joint once for vertex 0, found "joint 0 again" [skin/duplicate]; its weights are added up, here and in further rows',
    ],
    ({ skin }) => expect([...skin.weights]).toEqual([1, 1, 1]),
  ),
  readSkinOf(
    'B56 weights that do not sum to one',
    weights('1 0 0.5 1 0 1 1 0 1.25'),
    [
      ':3: expected weights that sum to 1 for every vertex, found "0.5 to 1.25 for 2" [character/weight-sum]; ' +
        'they are used as they are, vertex 1 being the farthest off; "normalize weights" divides them by their sum',
    ],
    ({ skin }) => expect([...skin.weights]).toEqual([0.5, 1, 1.25]),
  ),
  readSkinOf(
    'B57 a negative weight',
    weights('1 0 -1 1 0 1 1 0 1'),
    [
      ':3: expected weights of at least 0, found "negative ones for 1: vertex 1" [character/weight-negative]; they are kept as they are',
      ':3: expected weights that sum to 1 for every vertex, found "-1 for 1" [character/weight-sum]; ' +
        'they are used as they are, vertex 1 being the farthest off; "normalize weights" divides them by their sum',
    ],
    ({ skin }) => expect(skin.weights[0]).toBe(-1),
  ),
  noSkin(
    'B57 NaN for a weight',
    weights('1 0 nan'),
    ':3:21: expected a number for a weight of vertex 0, found "nan" [skin/number]',
  ),
  noSkin(
    'B57 a weight past any',
    weights('1 0 1e39'),
    ':3:21: expected a weight of vertex 0 within ±1e6, found "1e39" [skin/range]',
  ),
  {
    ...noSkin(
      'B57 a weight past a smaller limit',
      weights('1 0 11'),
      ':3:21: expected a weight of vertex 0 within ±1e1, found "11" [skin/range]',
    ),
    limits: { weight: 10 },
  },
  {
    title: 'B60 bindings of another skeleton',
    files: { ...whole, 'a.skel': 'balljoint a { balljoint b { offset 1 0 0 } }' },
    messages: [
      'error: a.skin: expected 2 bindings, one for each joint of a.skel, found "1" [skin/count]; the mesh is shown without its weights',
    ],
    left: { ...unbound, joints: 2 },
  },
  noSkin(
    'B60 fewer bindings than the file says',
    skinText({
      bindings: 'bindings 2 { matrix { 1 0 0 0 1 0 0 0 1 0 0 0 } /* and no other one */ }',
    }),
    ':5:72: expected 2 rows of bindings, as the file says, found "1" [skin/count]',
  ),
  noSkin(
    'B61 11 numbers',
    matrix('1 0 0 0 1 0 0 0 1 0 0'),
    ':5:45: expected 12 numbers, 4 rows of 3, found "11" [skin/matrix]',
  ),
  noSkin(
    'B61 13 numbers',
    matrix('1 0 0 0 1 0 0 0 1 0 0 0 0'),
    ':5:47: expected 12 numbers, 4 rows of 3, found "13 or more" [skin/matrix]',
  ),
  noSkin(
    'B62 a singular binding',
    matrix('1 0 0 1 0 0 0 0 1 0 0 0'),
    ':5:47: expected a matrix with an inverse for joint 0, found "determinant 0" [skin/singular]',
  ),
  noSkin(
    'B62 a binding that is nearly singular',
    matrix('1e-5 0 0 0 1e-5 0 0 0 1e-5 0 0 0'),
    ':5:56: expected a matrix with an inverse for joint 0, found "determinant 1e-15" [skin/singular]',
  ),
  readSkinOf('B63 a mirrored binding', matrix('-1 0 0 0 1 0 0 0 1 0 0 0'), [
    ':5:48: expected a matrix that does not mirror for joint 0, found "determinant -1" [skin/mirrored]; it is used as it is',
  ]),
  noSkin(
    'B64 NaN in a binding',
    matrix('1 0 0 0 NaN 0 0 0 1 0 0 0'),
    ':5:31: expected a number for an element of the matrix, found "NaN" [skin/number]',
  ),
  {
    title: 'B66 a skeleton with fewer joints than its skin',
    files: {
      ...whole,
      'a.skin': skinText({
        bindings: `bindings 2 { ${'matrix { 1 0 0 0 1 0 0 0 1 0 0 0 } '.repeat(2)}}`,
      }),
    },
    messages: [
      'error: a.skin: expected 1 bindings, one for each joint of a.skel, found "2" [skin/count]; the mesh is shown without its weights',
    ],
    left: unbound,
  },
  {
    ...noSkin(
      'B66 a brace too many',
      skinText({}, '}'),
      ':6:1: expected the name of a section, found "}" [skin/token]',
    ),
  },
];
