import { expect } from 'vitest';
import { type BadInput, square, withObj } from './bad-input.ts';

const noMesh = { joints: 3, vertices: 0, triangles: 0, bound: false };
const mesh = { joints: 3, vertices: 4, triangles: 1, bound: false };
const face = 'f 1 2 3\n';

function refused(title: string, text: string, message: string): BadInput {
  return { title, files: withObj(text), messages: [`error: a.obj${message}`], left: noMesh };
}

/** A square's points, these lines, and a face. */
function accepted(title: string, lines: string, ...messages: string[]): BadInput {
  return { title, files: withObj(`${square}${lines}${face}`), messages, left: mesh };
}

function ignored(line: number, found: string, kind = 'ignored'): string {
  const expected = 'vertices, texture coordinates, normals and faces';
  return `warning: a.obj:${line}:1: expected ${expected}, found "${found}" [obj/${kind}]`;
}

function noLibrary(line: number, found: string): string {
  const expected = 'the material library among the files';
  return `warning: a.obj:${line}:1: expected ${expected}, found "${found}" [obj/missing]`;
}

function materials(title: string, names: readonly string[]): BadInput {
  return {
    title,
    files: withObj(`${square}${names.map((name) => `usemtl ${name}\n${face}`).join('')}`),
    messages: [],
    left: { ...mesh, triangles: names.length },
    check(character) {
      expect(character.mesh.submeshes.map(({ material }) => material)).toEqual(names);
    },
  };
}

const strangeNames = [
  '__proto__',
  'constructor',
  '<img onerror=x>',
  '\u202egnp',
  'n'.repeat(10_000),
];
const manyWords = Array.from({ length: 150 }, (_, i) => `word${i} 1\nword${i} 2\n`).join('');

/** A28 to A32, A43 to A48, A50, A51, A53 and A54: all lines except faces. */
export const objLines: readonly BadInput[] = [
  refused(
    'A28 no vertex',
    '# nothing\no thing\n',
    ': expected at least one vertex, found "none" [obj/empty]',
  ),
  refused(
    'A29 vertex of two numbers',
    `${square}v 1 2\n${face}`,
    ':5: expected 3 numbers, found "2" [obj/field-count]',
  ),
  {
    title: 'A30 vertices with w and with colors',
    files: withObj(`v 0 0 0 1.0\nv 1 0 0 .5 .5 .5\nv 1 1 0\nv 0 1 0\n${face}`),
    messages: [],
    left: mesh,
    check: ({ mesh: { positions } }) =>
      expect([...positions]).toEqual([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]),
  },
  {
    title: 'A31 nan in a vertex',
    files: withObj(`${square}v nan 0 1.#IND\nf 1 2 5\n${face}`),
    messages: [
      'error: a.obj:5: expected vertices that are numbers, found "one that is not" [obj/number]',
    ],
    left: { ...mesh, vertices: 5 },
  },
  {
    title: 'A31 nan in a vertex of every triangle',
    files: withObj(`v nan 0 0\n${square}${face}`),
    messages: [
      'error: a.obj:1: expected vertices that are numbers, found "one that is not" [obj/number]',
      'error: a.obj: expected at least one triangle, found "none" [obj/empty]',
    ],
    left: noMesh,
  },
  {
    title: 'A31 nan in texture coordinates and normals',
    files: withObj(
      `${square}vt nan nan\nvt 0 1\nvt -nan(ind) 1.#QNAN\nvn inf 0 0\nf 1/1/1 2/2 3/3\n`,
    ),
    messages: [
      'warning: a.obj:5: expected texture coordinates that are numbers, ' +
        'found "2 that are not" [obj/number]',
      'warning: a.obj:8: expected normals that are numbers, found "1 that are not" [obj/number]',
    ],
    left: mesh,
    check: ({ mesh: { positions, normals } }) =>
      expect([...positions, ...normals].every(Number.isFinite)).toBe(true),
  },
  {
    title: 'A31 infinity, and nan of another country, in texture coordinates and normals',
    files: withObj(`${square}vt 1e400 0\nvt -1,#IND 0\nvn 1e39 0 0\nf 1/1/1 2/2 3/2\n`),
    messages: [
      'warning: a.obj:5: expected texture coordinates that are numbers, ' +
        'found "2 that are not" [obj/number]',
      'warning: a.obj:7: expected normals that are numbers, found "1 that are not" [obj/number]',
    ],
    left: mesh,
  },
  {
    title: 'A31 words in texture coordinates and normals',
    files: withObj(
      `${square}vt undefined undefined\nvt 0,5 1\nvt 0 ${'1'.repeat(100)}\nvn null 0 1\n` +
        'f 1/1/1 2/2 3/3\n',
    ),
    messages: [
      'warning: a.obj:5: expected texture coordinates that are numbers, ' +
        'found "3 that are not" [obj/number]',
      'warning: a.obj:8: expected normals that are numbers, found "1 that are not" [obj/number]',
    ],
    left: mesh,
    check: ({ mesh: { uvs } }) => expect([...(uvs ?? [])]).toEqual(new Array(8).fill(0)),
  },
  refused(
    'A32 beyond float32',
    `v 0 1e39 0\n${square}${face}`,
    ':1:5: expected y within ±1e18, found "1e39" [obj/range]',
  ),
  accepted(
    'A43 lines, points, curves',
    'l 1\nl 1 2\np 1\ncurv 0 1 1 2\nsurf 0 1 0 1 1 2\np 2\n',
    ...[ignored(5, 'l'), ignored(7, 'p'), ignored(8, 'curv'), ignored(9, 'surf')],
  ),
  accepted(
    'A44 library up the folders',
    'mtllib ../../secret\n',
    noLibrary(5, 'mtllib ../../secret'),
  ),
  accepted(
    'A44 library elsewhere',
    'mtllib http://example.com/a.mtl\n',
    noLibrary(5, 'mtllib http://example.com/a.mtl'),
  ),
  materials('A45 names of materials', strangeNames),
  accepted(
    'A45 names of objects and groups',
    strangeNames.map((name) => `o ${name}\ng ${name}\n`).join(''),
  ),
  {
    ...accepted('A46 continued line', `f 1 \\\n  2 4\\\n\n`),
    left: { ...mesh, triangles: 2 },
  },
  {
    title: 'A46 continued line at the end of the file',
    files: withObj(`${square}f 1 2 3 \\`),
    messages: [
      'warning: a.obj:5: expected a line after one that ends in \\, ' +
        'found "the end of the file" [file/continuation]',
    ],
    left: mesh,
  },
  {
    ...accepted('A46 continued line with blanks behind the backslash', `f 1 2 \\ \t\n 4\n`),
    left: { ...mesh, triangles: 2 },
  },
  ...['usemtl C:\\tex\\skin\\', 'g left\\', 'o C:\\a\\'].map((line) =>
    accepted(`A46 name that ends in a backslash: ${line}`, `${line}\n`),
  ),
  accepted(
    'A46 library that ends in a backslash',
    'mtllib D:\\out\\\n',
    noLibrary(5, 'mtllib D:\\out\\'),
  ),
  accepted('A46 comment that ends in a backslash', '# made from C:\\models\\\n'),
  {
    ...accepted('A46 comment behind a face that ends in a backslash', 'f 1 3 4 # in C:\\out\\\n'),
    left: { ...mesh, triangles: 2 },
  },
  ...['USEMTL C:\\tex\\', 'map_Kd C:\\tex\\', 'usemap D:\\'].map((line) =>
    accepted(
      `A46 unknown name that ends in a backslash: ${line}`,
      `${line}\n`,
      ignored(5, line.split(' ')[0]!, 'unknown'),
    ),
  ),
  accepted('A47 unknown word', 'foo 1 2\nfoo\n', ignored(5, 'foo', 'unknown')),
  accepted(
    'A47 150 unknown words',
    manyWords,
    ...[
      ...Array.from({ length: 100 }, (_, i) => ignored(5 + i * 2, `word${i}`, 'unknown')),
      'warning: a.obj: expected at most a hundred problems, found "50 more" [file/more]',
    ],
  ),
  accepted('A48 smoothing', 's off\ns\ns 1\n'),
  {
    title: 'A50 vertices that no face uses',
    files: withObj(`${square}v 9 9 9\n${face}`),
    messages: [],
    left: { ...mesh, vertices: 5 },
  },
  {
    title: 'A51 equal vertices',
    files: withObj(`v 0 0 0\n${square}${face}f 1 3 4\n`),
    messages: [],
    left: { ...mesh, vertices: 5, triangles: 2 },
    check: ({ mesh: { indices } }) => expect([...indices]).toEqual([0, 1, 2, 0, 2, 3]),
  },
  ...tooMany('vertices', { pointCount: 3 }, square, 'at most 3 vertices', 4),
  ...tooMany('triangles', { triangleCount: 1 }, `${square}f 1 2 3 4\n`, 'at most 1 triangles', 5),
  ...tooMany(
    'texture coordinates',
    { triangleCount: 1 },
    `${square}vt 0\nvt 0\nvt 0\nvt 0\n`,
    'at most 3 texture coordinates',
    8,
  ),
  refused(
    'A54 extent that can not be computed with',
    `v 0 0 1e30\n${square}${face}`,
    ':1:7: expected z within ±1e18, found "1e30" [obj/range]',
  ),
];

/** One error, after which nothing is read. */
function tooMany(
  what: string,
  limits: NonNullable<BadInput['limits']>,
  text: string,
  expected: string,
  line: number,
): BadInput[] {
  const column = what === 'triangles' ? ':10' : '';
  return [
    {
      title: `A53 more ${what} than the limit`,
      files: withObj(`${text}f x\nv y\n`),
      limits,
      messages: [`error: a.obj:${line}${column}: expected ${expected}, found "more" [obj/limit]`],
      left: noMesh,
    },
  ];
}
