import { expect } from 'vitest';
import { type BadInput, square, withObj } from './bad-input.ts';

const noMesh = { joints: 3, vertices: 0, triangles: 0, bound: false };

/** A square's points, this face, and a valid one. */
function refused(title: string, face: string, message: string): BadInput {
  return {
    title,
    files: withObj(`${square}${face}\nf 1 2 3\n`),
    messages: [`error: a.obj${message}`],
    left: noMesh,
  };
}

/** A face that is left out, or part of it, while the rest is kept. */
function leftOut(title: string, face: string, message: string, triangles = 1): BadInput {
  return {
    title,
    files: withObj(`${square}${face}\nf 1 2 3\n`),
    messages: [`warning: a.obj: ${message}`],
    left: { joints: 3, vertices: 4, triangles, bound: false },
  };
}

function noCorner(title: string, face: string, column: number, found: string): BadInput {
  const expected = 'expected a corner "v", "v/vt", "v//vn" or "v/vt/vn"';
  return refused(title, face, `:5:${column}: ${expected}, found "${found}" [obj/face]`);
}

const range = 'expected 1 to 4 or -4 to -1';
const few = 'expected faces of at least 3 corners, found "1 of fewer" [obj/face]';
const open = 'expected corners that end in a number, found "3 that end in a slash" [obj/face]';

/** The points of an outline, and one face over all of them. */
function polygon(points: readonly (readonly [number, number])[]): string {
  const lines = points.map(([x, y]) => `v ${x} ${y} 0\n`).join('');
  return `${lines}f ${points.map((_, i) => i + 1).join(' ')}\n`;
}

function cut(title: string, points: readonly (readonly [number, number])[]): BadInput {
  return {
    title,
    files: withObj(polygon(points)),
    messages: [],
    left: { joints: 3, vertices: points.length, triangles: points.length - 2, bound: false },
    check({ mesh }) {
      for (let i = 0; i < mesh.indices.length; i += 3) {
        const [a, b, c] = [0, 1, 2].map((k) => points[mesh.indices[i + k]!]!);
        const area = (b![0] - a![0]) * (c![1] - a![1]) - (b![1] - a![1]) * (c![0] - a![0]);
        expect(area).toBeGreaterThan(0); // no triangle outside, none reversed
      }
    },
  };
}

const round = Array.from({ length: 12 }, (_, i) => {
  const angle = (i * Math.PI) / 6;
  return [Math.cos(angle), Math.sin(angle)] as const;
});
const star: readonly (readonly [number, number])[] = round.map(([x, y], i) =>
  i % 2 ? [x / 3, y / 3] : [x, y],
);
const huge = `f ${Array.from({ length: 100_000 }, (_, i) => (i % 4) + 1).join(' ')}`;

/** A33 to A42, A49 and A52: faces. */
export const objFaces: readonly BadInput[] = [
  refused('A33 index 0', 'f 0 1 2', `:5:3: ${range}, found "0" [obj/index]`),
  refused('A34 index past the end', 'f 1 2 9', `:5:7: ${range}, found "9" [obj/index]`),
  refused('A35 index before the start', 'f -1 -2 -9', `:5:9: ${range}, found "-9" [obj/index]`),
  {
    title: 'A36 counted back, vertices and faces by turns',
    files: withObj('v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf -4 -3 -1\n'),
    messages: [],
    left: { joints: 3, vertices: 4, triangles: 2, bound: false },
    check: ({ mesh }) => expect([...mesh.indices]).toEqual([0, 1, 2, 0, 1, 3]),
  },
  refused(
    'A37 vertex that comes later',
    'f 1 2 6\nv 0 0 1\nv 0 0 2',
    `:5:7: ${range}; vertex 6 comes later, in line 7, found "6" [obj/index]`,
  ),
  leftOut('A38 two corners', 'f 1 2', few),
  leftOut('A38 one corner', 'f 1', few),
  leftOut('A38 no corner', 'f', few),
  leftOut('A38 two corners of vertices that are not there', 'f 1 9', few),
  leftOut('A38 one corner that is a word', 'f x', few),
  leftOut('A38 an outline of degenerate faces', 'f 1 2\nf 3', few.replace('1 of', '2 of')),
  {
    title: 'A39 triangles of two vertices',
    files: withObj(`${square}f 1 1 2\nf 1 2 3\nf 1 2 1\n`),
    messages: [
      'warning: a.obj: expected triangles of three different vertices, ' +
        'found "2 that are not" [obj/degenerate]',
    ],
    left: { joints: 3, vertices: 4, triangles: 1, bound: false },
  },
  cut(
    'A40 square',
    round.filter((_, i) => i % 3 === 0),
  ),
  cut('A40 polygon of 12', round),
  cut('A40 polygon with dents', star),
  refused(
    'A40 polygon of 100,000',
    huge,
    ':5:200002: expected a face of at most 10000 corners, found "100000" [obj/limit]',
  ),
  noCorner('A41 four numbers', 'f 1/2/3/4 2 3', 3, '1/2/3/4'),
  leftOut('A41 slashes at the end', 'f 1/ 2// 3/', open, 2),
  leftOut('A41 slashes behind three numbers', 'vt 0 0\nvn 0 0 1\nf 1/1/1/ 2//1/ 3///', open, 2),
  leftOut('A41 slashes between blanks', 'f 1 / 2 / 3 /', open, 2),
  noCorner('A41 a slash before all corners', 'f / 1 2 3', 3, '/'),
  noCorner('A41 slashes alone', 'f // 2 3', 3, '//'),
  noCorner('A41 words', 'f a/b/c 2 3', 3, 'a/b/c'),
  noCorner('A41 fraction', 'f 1 2.5 3', 5, '2.5'),
  {
    title: 'A42 texture coordinate and normal that are not there',
    files: withObj(`${square}f 1/9/1 2/9/1 3/9/1\nf 1/8/2 3 4\n`),
    messages: [
      'warning: a.obj:5:3: expected no texture coordinate, as none came before, ' +
        'found "9" [obj/index]',
      'warning: a.obj:5:3: expected no normal, as none came before, found "1" [obj/index]',
    ],
    left: { joints: 3, vertices: 4, triangles: 2, bound: false },
    check: ({ mesh }) => expect([...mesh.indices]).toEqual([0, 1, 2, 0, 2, 3]),
  },
  {
    title: 'A42 texture coordinate past the last',
    files: withObj(`${square}vt 0 0\nvt 1 0\nf 1/1 2/2 3/3\n`),
    messages: ['warning: a.obj:7:11: expected 1 to 2 or -2 to -1, found "3" [obj/index]'],
    left: { joints: 3, vertices: 4, triangles: 1, bound: false },
  },
  {
    title: 'A49 no triangle but degenerate ones',
    files: withObj(`${square}f 1 1 2\nf 3 3 3\n`),
    messages: [
      'error: a.obj: expected at least one triangle, found "none" [obj/empty]',
      'warning: a.obj: expected triangles of three different vertices, ' +
        'found "2 that are not" [obj/degenerate]',
    ],
    left: noMesh,
  },
  noCorner('A52 exponent', 'f 1 2e0 3', 5, '2e0'),
  noCorner('A52 plus sign', 'f +1 2 3', 3, '+1'),
  noCorner('A52 hexadecimal', 'f 0x1 2 3', 3, '0x1'),
  refused(
    'A52 index that wraps to 1 in 32 bits',
    'f 4294967297 2 3',
    `:5:3: ${range}, found "4294967297" [obj/index]`,
  ),
  noCorner('A52 index of too many digits', `f ${'0'.repeat(64)}1 2 3`, 3, `${'0'.repeat(40)}…`),
];
