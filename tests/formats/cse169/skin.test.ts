import { describe, expect, it } from 'vitest';
import { worldMatrices } from '../../../src/core/forward-kinematics.ts';
import { readSkin } from '../../../src/formats/cse169/skin.ts';
import { linearBlend } from '../../../src/skinning/linear-blend.ts';
import { skinVertices } from '../../../src/skinning/skin-vertices.ts';
import {
  inverse,
  multiply,
  rotationAbout,
  transform,
  translation,
} from '../../reference/matrix.ts';
import { leg, legSkin } from '../../support/cse169-files.ts';
import { largestDifference, numbersAt } from '../../support/compare.ts';
import { shown } from '../../support/diagnose.ts';
import { bytesOf, readOne } from '../../support/files.ts';

const minimal = {
  positions: 'positions 3 { 0 0 0 1 0 0 0 1 0 }',
  normals: 'normals 3 { 0 0 1 0 0 1 0 0 1 }',
  skinweights: 'skinweights 3 { 1 0 1 1 0 1 1 0 1 }',
  triangles: 'triangles 1 { 0 1 2 }',
  bindings: 'bindings 1 { matrix { 1 0 0 0 1 0 0 0 1 0 0 0 } }',
};

function read(content: string | Uint8Array) {
  const { value, diagnostics } = readSkin('a.skin', bytesOf(content));
  return { value, messages: shown(diagnostics) };
}

/** The minimal skin with some of its sections put in other words. */
function skinWith(changed: Partial<typeof minimal>, more = ''): string {
  return [...Object.values({ ...minimal, ...changed }), more].join('\n');
}

const effect = 'the mesh is not used';

describe('readSkin', () => {
  it('reads positions, normals, texcoords, weights, triangles, bindings and the material', () => {
    const { value, messages } = read(legSkin);
    expect(messages).toEqual([]);
    const { mesh, skin } = value!;
    expect(mesh.positions).toHaveLength(12);
    expect([...mesh.cornerPoints]).toEqual([0, 1, 2, 2, 1, 3]);
    expect(mesh.uvs![4]).toBeCloseTo(1.07);
    expect(mesh.materials).toEqual([{ name: 'skin', texture: 'leg.bmp' }]);
    expect(mesh.submeshes).toEqual([{ material: 'skin', firstTriangle: 0 }]);
    expect([...skin!.start]).toEqual([0, 1, 3, 6, 7]);
    expect([...skin!.joints]).toEqual([0, 0, 1, 0, 1, 2, 2]);
    expect([...skin!.weights]).toEqual([1, 0.5, 0.5, 0.25, 0.5, 0.25, 1]);
  });

  it('takes rows of a binding for its columns, the fourth for the translation', () => {
    const { skin } = read(legSkin).value!;
    const first = Array.from(skin?.bindFromJoint ?? []).slice(0, 16);
    expect(first).toEqual([0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 1]);
    // Its inverse takes the joint's place to the origin, and what is above it to the joint's x.
    const jointFromBind = numbersAt(skin?.jointFromBind ?? [], 0, 16);
    const apply = (x: number, y: number, z: number): number[] =>
      [0, 1, 2].map((row) =>
        [x, y, z, 1].reduce((sum, v, column) => sum + v * jointFromBind[column * 4 + row]!, 0),
      );
    expect(largestDifference(apply(0, 1, 0), [0, 0, 0])).toBeLessThan(1e-12);
    expect(largestDifference(apply(0, 2, 0), [1, 0, 0])).toBeLessThan(1e-12);
  });

  it('deforms by the rotated and sheared bindings of the file, never the rest pose', async () => {
    const character = await readOne(leg);
    const { skeleton, mesh, skin } = character;
    const pose = { q: skeleton.qRest };
    const { positions } = skinVertices(character, skin, pose, linearBlend);
    const [x, y, z] = [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ];
    const joint = (offset: number[], [a, b, c]: number[]) =>
      [rotationAbout(z, c!), rotationAbout(y, b!), rotationAbout(x, a!)].reduce(
        multiply,
        translation(offset),
      );
    const hip = joint([0, 1, 0], [0.5, 0, 0.25]);
    const knee = multiply(hip, joint([0, -0.5, 0], [0, -0.25, 0.75]));
    const foot = multiply(knee, translation([0, -0.5, 0.1]));
    const binds = [
      [
        [0, -1, 0, 0],
        [1, 0, 0, 1],
        [0, 0, 1, 0],
        [0, 0, 0, 1],
      ],
      [
        [1, 0, 0, 0],
        [0, 0, -1, 0.5],
        [0, 1, 0, 0],
        [0, 0, 0, 1],
      ],
      [
        [1, 0, 0, 0],
        [0.5, 2, 0, 0],
        [0, 0, 1, 0.1],
        [0, 0, 0, 1],
      ],
    ];
    const matrices = [hip, knee, foot].map((world, i) => multiply(world, inverse(binds[i]!)));
    const rows = [
      [[0, 1]],
      [
        [0, 0.5],
        [1, 0.5],
      ],
      [
        [0, 0.25],
        [1, 0.5],
        [2, 0.25],
      ],
      [[2, 1]],
    ];
    const expected = rows.flatMap((row, point) => {
      const moved = row.map(([j, w]) =>
        transform(matrices[j!]!, numbersAt(mesh.positions, point, 3)).map((value) => value * w!),
      );
      return [0, 1, 2].map((axis) => moved.reduce((sum, at) => sum + at[axis]!, 0));
    });
    expect(largestDifference(positions, expected)).toBeLessThan(1e-6);
    const world = worldMatrices(skeleton, skeleton.qRest);
    expect(
      largestDifference(
        numbersAt(world, 2, 16),
        foot[0]!.flatMap((_, c) => foot.map((r) => r[c]!)),
      ),
    ).toBeLessThan(1e-12);
  });

  it('takes the printed form, without "{" after skinweights and bindings', () => {
    const printed = skinWith({
      skinweights: 'skinweights 3 1 0 1 1 0 1 1 0 1 }',
      bindings: 'bindings 1 matrix { 1 0 0 0 1 0 0 0 1 0 0 0 } }',
    });
    expect(read(printed)).toEqual(read(skinWith({})));
    const open = skinWith({ skinweights: 'skinweights 3 1 0 1 1 0 1 1 0 1' });
    expect(read(open)).toEqual(read(skinWith({})));
  });

  // B37
  it('takes sections in any order', () => {
    const reversed = Object.values(minimal).toReversed().join(' ');
    expect(read(reversed)).toEqual(read(skinWith({})));
  });

  it('is a mesh without weights where there are no skinweights or no bindings', () => {
    for (const missing of ['skinweights', 'bindings']) {
      const { value, messages } = read(skinWith({ [missing]: '' }));
      expect(value?.skin).toBeUndefined();
      expect(value?.mesh.positions).toHaveLength(9);
      expect(messages).toEqual([
        `warning: a.skin: expected "skinweights" and "bindings", found "no ${missing}" ` +
          '[skin/section]; the mesh is shown undeformed',
      ]);
    }
  });

  it.each([
    // B39
    [
      skinWith({}, 'bones 3 { a { 1 } }'),
      '6:1: expected a word of this format, found "bones" [skin/unknown]; it is skipped, with its numbers or its block',
    ],
    // B47, B49
    [
      skinWith({ normals: '' }),
      ': expected normals, found "none" [skin/normal]; they are computed from the triangles',
    ],
    [
      skinWith({ normals: 'normals 3 { 0 0 0 0 0 1 0 0 1 }' }),
      ': expected normals with a length, found "1 without" [skin/normal]; they are computed from the triangles',
    ],
    // B55
    [
      skinWith({ skinweights: 'skinweights 3 { 2 0 .5 0 .5 1 0 1 1 0 1 }' }),
      '3:24: expected each joint once for vertex 0, found "joint 0 again" [skin/duplicate]; its weights are added up, here and in further rows',
    ],
    // B59
    [
      skinWith({ triangles: 'triangles 2 { 0 1 2 0 0 1 }' }),
      '4:27: expected triangles of three corners, found "1 with a corner twice" [skin/degenerate]; they are left out',
    ],
    // B63
    [
      skinWith({ bindings: 'bindings 1 { matrix { -1 0 0 0 1 0 0 0 1 0 0 0 } }' }),
      '5:48: expected a matrix that does not mirror for joint 0, found "determinant -1" [skin/mirrored]; it is used as it is',
    ],
    // B65
    [
      skinWith({}, 'texcoords 2 { 0 0 1 1 }'),
      ': expected 3 texcoords, one for each position, found "2" [skin/uv]; they are not used',
    ],
  ])('reads %j and warns', (text, message) => {
    const { value, messages } = read(text);
    expect(messages).toEqual([`warning: a.skin${message.startsWith(':') ? '' : ':'}${message}`]);
    expect(value?.mesh.cornerPoints).toHaveLength(3);
  });

  it.each([
    // B36, B59
    [skinWith({ positions: '' }), ': expected a section "positions", found "none" [skin/section]'],
    [skinWith({ triangles: '' }), ': expected a section "triangles", found "none" [skin/section]'],
    // B38
    [
      skinWith({}, minimal.normals),
      '6:1: expected one section "normals", found "another" [skin/duplicate]',
    ],
    // B40, B41, B45
    [
      skinWith({ positions: 'positions 4 { 0 0 0 1 0 0 0 1 0 }' }),
      '1:33: expected 4 rows of positions, as the file says, found "3" [skin/count]',
    ],
    [
      skinWith({ positions: 'positions 2 { 0 0 0 1 0 0 0 1 0 }' }),
      '1:27: expected 2 rows of positions, as the file says, found "more" [skin/count]',
    ],
    [
      skinWith({ positions: 'positions 3 { 0 0 0 1 0 0 0 1 }' }),
      '1:31: expected a number for positions, found "}" [skin/number]',
    ],
    // B42
    [
      skinWith({ positions: 'positions -1 { }' }),
      '1:11: expected how many rows of positions, a whole number, found "-1" [skin/integer]',
    ],
    [
      skinWith({ positions: 'positions 1.5 { }' }),
      '1:11: expected how many rows of positions, a whole number, found "1.5" [skin/integer]',
    ],
    // B43
    [
      'positions 4294967295 { 0 0 0 }',
      '1:11: expected at most 4000000 rows of positions, found "4294967295" [skin/limit]',
    ],
    [
      'positions 3000000 { 0 0 0 }',
      '1:11: expected at most 1 rows of positions, for the file has no room for more, found "3000000" [skin/count]',
    ],
    // B44
    [
      skinWith({ triangles: 'triangles 0 { }' }),
      ': expected at least one of "triangles", found "0" [skin/empty]',
    ],
    // B46, B50
    [
      skinWith({ normals: 'normals 2 { 0 0 1 0 0 1 }' }),
      ': expected 3 normals, one for each position, found "2" [skin/count]',
    ],
    [
      skinWith({ skinweights: 'skinweights 2 { 1 0 1 1 0 1 }' }),
      ': expected 3 rows of skinweights, one for each position, found "2" [skin/count]',
    ],
    // B52
    [
      skinWith({ skinweights: 'skinweights 3 { -1 0 1 1 0 1 1 0 1 }' }),
      '3:17: expected how many influences of vertex 0, a whole number, found "-1" [skin/integer]',
    ],
    [
      skinWith({ skinweights: 'skinweights 3 { 1000000000 0 1 }' }),
      '3:17: expected at most 4096 influences of vertex 0, found "1000000000" [skin/limit]',
    ],
    // B53, B54
    [
      skinWith({ skinweights: 'skinweights 3 { 1 0 1 1 0 1 1 23 1 }' }),
      ': expected joints from 0 to 0, for which there are bindings, found "23, vertex 2" [skin/index]',
    ],
    [
      skinWith({ skinweights: 'skinweights 3 { 1 -1 1 1 0 1 1 0 1 }' }),
      '3:19: expected a whole number for a joint of vertex 0, 0 or more, found "-1" [skin/integer]',
    ],
    // B57
    [
      skinWith({ skinweights: 'skinweights 3 { 1 0 nan }' }),
      '3:21: expected a number for a weight of vertex 0, found "nan" [skin/number]',
    ],
    [
      skinWith({ skinweights: 'skinweights 3 { 1 0 1e39 }' }),
      '3:21: expected a weight of vertex 0 within ±1e6, found "1e39" [skin/range]',
    ],
    // B58
    [
      skinWith({ triangles: 'triangles 1 { 0 1 3 }' }),
      ': expected vertices from 0 to 2, found "3, triangle 0" [skin/index]',
    ],
    [
      skinWith({ triangles: 'triangles 1 { 0 1 -1 }' }),
      '4:19: expected a whole number for a corner of triangle 0, 0 or more, found "-1" [skin/integer]',
    ],
    // B61
    [
      skinWith({ bindings: 'bindings 1 { matrix { 1 0 0 0 1 0 0 0 1 0 0 } }' }),
      '5:45: expected 12 numbers, 4 rows of 3, found "11" [skin/matrix]',
    ],
    [
      skinWith({ bindings: 'bindings 1 { matrix { 1 0 0 0 1 0 0 0 1 0 0 0 0 } }' }),
      '5:47: expected 12 numbers, 4 rows of 3, found "13 or more" [skin/matrix]',
    ],
    // B62
    [
      skinWith({ bindings: 'bindings 1 { matrix { 1 0 0 1 0 0 0 0 1 0 0 0 } }' }),
      '5:47: expected a matrix with an inverse for joint 0, found "determinant 0" [skin/singular]',
    ],
    // B64
    [
      skinWith({ bindings: 'bindings 1 { matrix { NaN 0 0 1 0 0 0 0 1 0 0 0 } }' }),
      '5:23: expected a number for an element of the matrix, found "NaN" [skin/number]',
    ],
    // B66
    [
      'positions 3 { 0 0 0 1 0 0 0 1 0',
      '1:32: expected "}" for positions, found "the end of the file" [skin/end]',
    ],
    [skinWith({}, '}'), '6:1: expected the name of a section, found "}" [skin/token]'],
  ])('refuses %j', (text, message) => {
    expect(read(text)).toEqual({
      value: undefined,
      messages: [`error: a.skin${message.startsWith(':') ? '' : ':'}${message}; ${effect}`],
    });
  });
});
