import { describe, expect, it } from 'vitest';
import { jointMatrices } from '../../../src/core/forward-kinematics.ts';
import { readSkin } from '../../../src/formats/cse169/skin.ts';
import { linearBlend } from '../../../src/skinning/linear-blend.ts';
import { skinVertices } from '../../support/skin-vertices.ts';
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
import { skinText } from './bad-input/bad-input.ts';

function read(content: string | Uint8Array) {
  const { value, diagnostics } = readSkin('a.skin', bytesOf(content));
  return { value, messages: shown(diagnostics) };
}

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

  it('reads the rows of a binding as its columns, the fourth as the translation', () => {
    const { skin } = read(legSkin).value!;
    const first = Array.from(skin?.bindFromJoint ?? []).slice(0, 16);
    expect(first).toEqual([0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 1]);
    // Its inverse maps the joint's position to the origin, and a point above it to the joint's x
    // axis.
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
    const world = jointMatrices(skeleton, skeleton.qRest);
    expect(
      largestDifference(
        numbersAt(world, 2, 16),
        foot[0]!.flatMap((_, c) => foot.map((r) => r[c]!)),
      ),
    ).toBeLessThan(1e-12);
  });

  it('accepts the form of the assignment, without "{" after skinweights and bindings', () => {
    const printed = skinText({
      skinweights: 'skinweights 3 1 0 1 1 0 1 1 0 1 }',
      bindings: 'bindings 1 matrix { 1 0 0 0 1 0 0 0 1 0 0 0 } }',
    });
    expect(read(printed)).toEqual(read(skinText()));
    const open = skinText({ skinweights: 'skinweights 3 1 0 1 1 0 1 1 0 1' });
    expect(read(open)).toEqual(read(skinText()));
  });

  it('is a mesh without weights where there are no skinweights or no bindings', () => {
    for (const missing of ['skinweights', 'bindings']) {
      const { value, messages } = read(skinText({ [missing]: '' }));
      expect(value?.skin).toBeUndefined();
      expect(value?.mesh.positions).toHaveLength(9);
      expect(messages).toEqual([
        `warning: a.skin: expected "skinweights" and "bindings", found "no ${missing}" ` +
          '[skin/section]; the mesh is shown undeformed',
      ]);
    }
  });
});
