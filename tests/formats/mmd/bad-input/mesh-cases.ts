import { bonesOf } from '../../../../src/core/bones.ts';
import { expect } from 'vitest';
import { mmdOf } from '../../../../src/formats/mmd/mmd-parts.ts';
import { square, squarePmd } from '../../../support/pmd-files.ts';
import {
  at,
  type BadPmd,
  bonesOnly,
  changed,
  materialAt,
  put,
  putCount,
  putFloat,
  refused,
  vertexAt,
  warned,
  whole,
} from './bad-pmd.ts';

const bytesLeft = (offset: number): number => squarePmd.length - offset - 4;

function tooMany(title: string, offset: number, count: number, what: string, each: number): BadPmd {
  const left = bytesLeft(offset);
  const message = `at most ${Math.floor(left / each)} ${what} of ${each} bytes in the ${left} bytes left`;
  const found = `, found "${count}" [pmd/count]`;
  return refused(title, putCount(offset, count), offset, `${message}${found}`);
}

function badBone(title: string, which: 0 | 1, bone: number, found: string): BadPmd {
  const offset = vertexAt(1) + 32 + which * 2;
  const message = `bones from 0 to 3, found "${found}, vertex 1" [pmd/index]`;
  return refused(title, put(offset, bone & 0xff, bone >> 8), offset, message);
}

const materials = square.materials;
const [threeMore, none] = [
  { ...materials[1]!, count: 6 },
  { ...materials[1]!, count: 0 },
];

function texture(title: string, name: string, file: string, messages: string[] = []): BadPmd {
  const bytes = changed({ materials: [{ ...materials[0]!, texture: name }, materials[1]!] });
  return {
    ...warned(title, bytes, [], ({ missing }) => expect(missing).toEqual([])),
    beside: { [file]: Uint8Array.of(0) },
    messages,
  };
}

/** C24 to C51: vertices, triangles and materials. */
export const meshCases: readonly BadPmd[] = [
  warned(
    'C24 no vertices',
    changed({ vertices: [], indices: [], materials: [], morphs: [], shownMorphs: [] }),
    [[at.vertices + 4, 'vertices, found "none" [pmd/empty]']],
    (character) => expect(bonesOf(character).length).toBeGreaterThan(0),
    bonesOnly,
  ),
  tooMany('C25 four billion vertices', at.vertices, 0xffffffff, 'vertices', 38),
  refused(
    'C26 a vertex too many',
    putCount(at.vertices, 5).subarray(0, at.indices),
    at.vertices,
    'at most 4 vertices of 38 bytes in the 152 bytes left, found "5" [pmd/count]',
  ),
  tooMany('C27 vertices of just over 2^32 bytes', at.vertices, 113_025_456, 'vertices', 38),
  refused(
    'C28 NaN position',
    putFloat(vertexAt(2) + 4, NaN),
    vertexAt(2) + 4,
    'a position, found "NaN, vertex 2" [pmd/number]',
  ),
  refused(
    'C28 infinite position',
    putFloat(vertexAt(2) + 8, -Infinity),
    vertexAt(2) + 8,
    'a position, found "-Infinity, vertex 2" [pmd/number]',
  ),
  warned(
    'C29 NaN normal',
    putFloat(vertexAt(0) + 16, NaN),
    [[vertexAt(0) + 12, 'normals with a length, found "0 NaN -1, vertex 0" [pmd/normal]']],
    ({ mesh }) => expect([...mesh.normals.subarray(0, 3)]).toEqual([0, 0, 1]),
  ),
  warned(
    'C30 NaN texture coordinate',
    putFloat(vertexAt(1) + 24, NaN),
    [[vertexAt(1) + 24, 'texture coordinates that are numbers, found "NaN 1, vertex 1" [pmd/uv]']],
    (character) => expect([...mmdOf(character)!.vertices.uvs.subarray(2, 4)]).toEqual([0, 0]),
  ),
  warned('C31 subnormal position', putFloat(vertexAt(0), 1e-40), [], ({ mesh }) =>
    expect(mesh.positions[0]).toBe(0),
  ),
  refused(
    'C32 position of 1e38',
    putFloat(vertexAt(3), 1e38),
    vertexAt(3),
    `a position within ±1e18, found "${Math.fround(1e38)}, vertex 3" [pmd/range]`,
  ),
  badBone('C33 bone past the end', 0, 4, '4'),
  badBone('C33 second bone past the end', 1, 260, '260'),
  badBone('C34 bone 0xFFFF', 0, 0xffff, '65535'),
  warned('C34 bone 0xFFFF without weight', put(vertexAt(0) + 34, 0xff, 0xff), []),
  warned('C35 both bones equal', squarePmd, [], ({ skin }) => {
    expect([...skin.start]).toEqual([0, 1, 3, 5, 6]);
    expect(skin.weights[5]).toBe(1);
  }),
  warned(
    'C36 weight of 255',
    put(vertexAt(1) + 36, 255),
    [[vertexAt(1) + 36, 'weights from 0 to 100, found "255, vertex 1" [pmd/range]']],
    (character) => {
      expect(character.skin.weights[1]).toBe(1);
      expect(mmdOf(character)!.vertices.weights[1]).toBe(100);
    },
  ),
  warned(
    'C37 edge flag of 2',
    put(vertexAt(0) + 37, 2),
    [[vertexAt(0) + 37, 'edge flags of 0 or 1, found "2, vertex 0" [pmd/range]']],
    (character) => expect([...mmdOf(character)!.vertices.edgeFlags]).toEqual([1, 1, 0, 0]),
  ),
  refused(
    'C38 four indices',
    changed({ indices: [0, 1, 2, 3] }),
    at.indices,
    'three indices for each triangle, found "4" [pmd/count]',
  ),
  refused(
    'C39 index past the end',
    changed({ indices: [0, 2, 1, 0, 4, 2] }),
    at.indices + 4 + 8,
    'vertices from 0 to 3, found "4, triangle 1" [pmd/index]',
  ),
  warned(
    'C40 no indices',
    changed({ indices: [], materials: [] }),
    [[at.indices, 'triangles, found "none" [pmd/empty]']],
    undefined,
    { ...whole, triangles: 0 },
  ),
  tooMany('C41 four billion indices', at.indices, 0xffffffff, 'indices of vertices', 2),
  warned(
    'C42 more vertices than 16 bits reach',
    changed({ vertices: new Array(65_537).fill(square.vertices[0]) as typeof square.vertices }),
    [
      [
        at.vertices + 4 + 65_537 * 38,
        'at most 65536 vertices, which is what the indices reach, found "65537" [pmd/limit]',
      ],
    ],
    undefined,
    { ...whole, vertices: 65_537 },
  ),
  warned('C43 a triangle with a corner twice', changed({ indices: [0, 2, 1, 0, 3, 3] }), [
    [
      at.indices + 4 + 6,
      'triangles of three different vertices, found "triangle 1" [pmd/degenerate]',
    ],
  ]),
  tooMany('C44 four billion materials', at.materials, 0xffffffff, 'materials', 70),
  warned(
    'C45 materials for a part of the triangles',
    changed({ materials: [materials[0]!, none] }),
    [[at.materials, 'materials for all 6 indices, found "3" [pmd/count]']],
    ({ mesh, materials: own }) => {
      expect(own).toHaveLength(3);
      expect(mesh.submeshes.map(({ material }) => material)).toEqual([
        'material 00',
        'material 02',
      ]);
    },
  ),
  refused(
    'C46 materials for more than there is',
    changed({ materials: [materials[0]!, threeMore] }),
    materialAt(1) + 46,
    'at most 3 indices for material 1, those that are left, found "6" [pmd/count]',
  ),
  refused(
    'C47 a material that ends within a triangle',
    changed({
      materials: [
        { ...materials[0]!, count: 4 },
        { ...none, count: 2 },
      ],
    }),
    materialAt(0) + 46,
    'three indices for each triangle of material 0, found "4" [pmd/count]',
  ),
  warned(
    'C48 NaN color',
    putFloat(materialAt(0) + 20, NaN),
    [
      [
        materialAt(0) + 20,
        'colors that are numbers, found "NaN 0.25 0.375, material 0" [pmd/number]',
      ],
    ],
    ({ materials: [first] }) => expect(first!.colors!.specular).toEqual([0, 0, 0]),
  ),
  ...[
    [-0.5, 0],
    [1.5, 1],
  ].map(([alpha, used]) =>
    warned(
      `C49 alpha of ${alpha!}`,
      putFloat(materialAt(0) + 12, alpha!),
      [[materialAt(0) + 12, `alpha from 0 to 1, found "${alpha!}, material 0" [pmd/range]`]],
      ({ materials: [first] }) => expect(first!.colors!.alpha).toBe(used),
    ),
  ),
  texture('C50 folders above', '..\\..\\x.bmp', 'Y/X.BMP', [
    'warning: a.pmd: expected images where its materials say, or beside it, ' +
      'found "Y/X.BMP" [file/pairing]',
  ]),
  texture('C50 a drive', 'C:\\x.png', 'x.png'),
  texture('C50 an address', 'http://x/y.jpg', 'y.jpg'),
  texture('C50 a sphere beside', 'a.bmp*b.sph', 'a.bmp'),
  texture('C50 20 bytes', 'abcdefghijklmnop.tga', 'abcdefghijklmnop.tga'),
  warned('C51 toon of 255', squarePmd, [], ({ materials: [, second] }) =>
    expect(second!.toon).toBe(-1),
  ),
  warned(
    'C51 toon of 200',
    put(materialAt(0) + 44, 200),
    [
      [
        materialAt(0) + 44,
        'a toon from 0 to 9, or none (255), found "200, material 0" [pmd/index]',
      ],
    ],
    ({ materials: [first] }) => expect(first!.toon).toBe(-1),
  ),
];
