import { expect } from 'vitest';
import {
  all,
  type BadInput,
  noSkin,
  readSkinOf,
  sections,
  skeletonOnly,
  skinText,
} from './bad-input.ts';

const positions = (text: string): string => skinText({ positions: `positions ${text}` });
const triangles = (text: string): string => skinText({ triangles: `triangles ${text}` });
/** A valid skin in another form. */
function sameSkin(title: string, text: string): BadInput {
  return readSkinOf(`B37 ${title}`, text, [], ({ mesh, skin }) => {
    expect([...mesh.positions]).toEqual([0, 0, 0, 1, 0, 0, 0, 1, 0]);
    expect([...mesh.indices]).toEqual([0, 1, 2]);
    expect([...skin.weights]).toEqual([1, 1, 1]);
  });
}

const said = ', as the file says, found';

/** B36 to B49, B58, B59 and part of B65: vertices and triangles. */
export const skinSections: readonly BadInput[] = [
  noSkin(
    'B36 no positions',
    skinText({ positions: '' }),
    ': expected a section "positions", found "none" [skin/section]',
  ),
  sameSkin('sections in another order', Object.values(sections).toReversed().join(' ')),
  sameSkin('lines that end with CR', skinText().replaceAll('\n', '\r')),
  sameSkin('lines that end with CR CR LF', skinText().replaceAll('\n', '\r\r\n')),
  sameSkin(
    'as the assignment prints it, without braces',
    skinText({
      skinweights: 'skinweights 3 1 0 1 1 0 1 1 0 1 }',
      bindings: 'bindings 1 matrix { 1 0 0 0 1 0 0 0 1 0 0 0 } }',
    }),
  ),
  noSkin(
    'B38 a section twice',
    skinText({}, sections.normals),
    ':6:1: expected one section "normals", found "another" [skin/duplicate]',
  ),
  readSkinOf('B39 an unknown section', skinText({}, 'bones 3 { a { 1 } }'), [
    ':6:1: expected a word of this format, found "bones" [skin/unknown]; it is skipped, with its numbers or its block',
  ]),
  readSkinOf('B39 an unknown section before the others', `version{ 1 }\n${skinText()}`, [
    ':1:1: expected a word of this format, found "version" [skin/unknown]; it is skipped, with its numbers or its block',
  ]),
  noSkin(
    'B40 a row too few',
    positions('4 { 0 0 0 1 0 0 0 1 0 }'),
    `:1:33: expected 4 rows of positions${said} "3" [skin/count]`,
  ),
  noSkin(
    'B41 a row too many',
    positions('2 { 0 0 0 1 0 0 0 1 0 }'),
    `:1:27: expected 2 rows of positions${said} "more" [skin/count]`,
  ),
  ...(['-1', '1.5', 'x'] as const).map((count) =>
    noSkin(
      `B42 ${count} positions`,
      positions(`${count} { 0 0 0 }`),
      `:1:11: expected how many rows of positions, a whole number, found "${count}" [skin/integer]`,
    ),
  ),
  noSkin(
    'B43 4,294,967,295 positions in a file of few bytes',
    'positions 4294967295 { 0 0 0 }',
    ':1:11: expected at most 1 rows of positions, for the file has no room for more, found "4294967295" [skin/count]',
  ),
  {
    ...noSkin(
      'B43 more positions than Sinew takes',
      positions('3 { 0 0 0 1 0 0 0 1 0 }'),
      ':1:11: expected at most 2 rows of positions, found "3" [skin/limit]',
    ),
    limits: { pointCount: 2 },
  },
  noSkin(
    'B44 no positions in the section',
    positions('0 { }'),
    ': expected at least one of "positions", found "0" [skin/empty]',
  ),
  noSkin(
    'B44 no triangles in the section',
    triangles('0 { }'),
    ': expected at least one of "triangles", found "0" [skin/empty]',
  ),
  noSkin(
    'B45 not a multiple of three',
    positions('3 { 0 0 0 1 0 0 0 1 }'),
    `:1:31: expected 3 rows of positions${said} "2 and 2 of 3 numbers" [skin/count]`,
  ),
  noSkin(
    'B45 a triangle of two corners',
    triangles('1 { 0 1 }'),
    `:4:19: expected 1 rows of triangles${said} "0 and 2 of 3 numbers" [skin/count]`,
  ),
  noSkin(
    'B45 a number too many',
    positions('3 { 0 0 0 1 0 0 0 1 0 7 }'),
    `:1:33: expected 3 rows of positions${said} "more" [skin/count]`,
  ),
  noSkin(
    'B46 fewer normals than positions',
    skinText({ normals: 'normals 2 { 0 0 1 0 0 1 }' }),
    ': expected 3 normals, one for each position, found "2" [skin/count]',
  ),
  readSkinOf(
    'B47 a normal without length',
    skinText({ normals: 'normals 3 { 0 0 0 0 0 1 0 0 1 }' }),
    [
      ':2: expected normals with a length, found "1 without" [skin/normal]; they are computed from the triangles',
    ],
    ({ mesh }) => expect([...mesh.normals.subarray(0, 3)]).toEqual([0, 0, 1]),
  ),
  noSkin(
    'B47 a normal of NaN',
    skinText({ normals: 'normals 3 { 0 0 nan 0 0 1 0 0 1 }' }),
    ':2:17: expected a number for normals, found "nan" [skin/number]',
  ),
  readSkinOf(
    'B48 normals of other lengths',
    skinText({ normals: 'normals 3 { 0 0 2 0 3 4 0.25 0 0 }' }),
    [],
    ({ mesh }) => {
      [0, 0, 1, 0, 0.6, 0.8, 1, 0, 0].forEach((value, i) =>
        expect(mesh.normals[i]).toBeCloseTo(value, 6),
      );
    },
  ),
  readSkinOf(
    'B49 no normals',
    skinText({ normals: '' }),
    [': expected normals, found "none" [skin/normal]; they are computed from the triangles'],
    ({ mesh }) => expect([...mesh.normals]).toEqual([0, 0, 1, 0, 0, 1, 0, 0, 1]),
  ),
  noSkin(
    'B58 a vertex past the end',
    triangles('1 { 0 1 3 }'),
    ':4: expected vertices from 0 to 2, found "3" [skin/index]',
  ),
  noSkin(
    'B58 a negative vertex',
    triangles('1 { 0 1 -1 }'),
    ':4:19: expected a whole number for a corner of triangle 0, 0 or more, found "-1" [skin/integer]',
  ),
  noSkin(
    'B59 no triangles',
    skinText({ triangles: '' }),
    ': expected a section "triangles", found "none" [skin/section]',
  ),
  readSkinOf('B59 a triangle with a corner twice', triangles('2 { 0 1 2 0 0 1 }'), [
    ':4:27: expected triangles of three corners, found "1 with a corner twice" [skin/degenerate]; they are left out',
  ]),
  readSkinOf(
    'B65 fewer texcoords than positions',
    skinText({}, 'texcoords 2 { 0 0 1 1 }'),
    [': expected 3 texcoords, one for each position, found "2" [skin/uv]; they are not used'],
    ({ mesh }) => expect(mesh.uvs).toBeNull(),
  ),
  readSkinOf(
    'B65 texcoords that are not numbers',
    skinText({}, 'texcoords 3 { 0 0 nan 1\n-nan(ind) undefined }'),
    [
      ':6:19: expected texcoords that are numbers, found "3 that are not" [skin/number]; they are not used',
    ],
    ({ mesh }) => expect(mesh.uvs).toBeNull(),
  ),
  noSkin(
    'B65 texcoords that end in a word',
    skinText({}, 'texcoords 3 { 0 0 0 1 material m { } }'),
    ':6:23: expected a number for texcoords, found "material" [skin/number]',
  ),
  ...(
    [
      '../../etc/passwd',
      'https://example.org/a.png',
      'C:\\textures\\a.bmp',
      'file:///a.jpg',
    ] as const
  ).map((texture) =>
    readSkinOf(
      `B65 texture ${texture}`,
      skinText({}, `material ${texture} { texture ${texture} }`),
      [],
      ({ materials }) => expect(materials).toEqual([{ name: texture, texture }]),
    ),
  ),
  {
    title: 'B66 end within a section',
    files: { 'a.skel': 'balljoint a { }', 'a.skin': 'positions 3 { 0 0 0 1 0 0 0 1 0' },
    messages: [
      'error: a.skin:1:32: expected "}" for positions, found "the end of the file" [skin/end]; the mesh is not used',
    ],
    left: skeletonOnly,
  },
  {
    ...readSkinOf('B66 a skin without its skeleton', skinText(), []),
    files: { 'a.skin': skinText() },
    left: { ...all, joints: 0, bound: false },
    check: ({ missing }) => expect(missing).toEqual(['.skel']),
  },
];
