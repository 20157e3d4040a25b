import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { buildCharacter } from '../../../src/core/build-character.ts';
import { buildMesh } from '../../../src/core/build-mesh.ts';
import type { Character } from '../../../src/core/character.ts';
import type { Mesh } from '../../../src/core/mesh.ts';
import { normalizeSkin } from '../../../src/core/skin.ts';
import { writeMit } from '../../../src/formats/mit/write-character.ts';
import { readObj } from '../../../src/formats/obj/read-obj.ts';
import { writeObj } from '../../../src/formats/obj/write-obj.ts';
import { loadedKernels } from '../../support/kernels.ts';
import { skinVertices } from '../../support/skin-vertices.ts';
import { jointMatrices } from '../../../src/core/forward-kinematics.ts';
import { readOne } from '../../support/files.ts';
import { meshParts, skinnedParts } from '../../support/random-parts.ts';

/** Joins adjacent runs of one material, because writing does not distinguish them. */
function withoutSeams({ submeshes, ...mesh }: Mesh) {
  const triangles = submeshes.flatMap(({ material, indexCount }) =>
    new Array<string>(indexCount / 3).fill(material),
  );
  return { ...mesh, materials: triangles };
}

function built(parts: Parameters<typeof buildCharacter>[0]): Character {
  const { value, diagnostics } = buildCharacter(parts);
  if (!value) throw new Error(JSON.stringify(diagnostics));
  return value;
}

describe('random meshes', () => {
  it('are the same when written and read again, normals and all', async () => {
    await fc.assert(
      fc.asyncProperty(meshParts, async (parts) => {
        const mesh = buildMesh(parts);
        const { value, diagnostics } = await readObj('a.obj', writeObj(mesh));
        expect(diagnostics).toEqual([]);
        expect(withoutSeams(buildMesh(value!))).toEqual(withoutSeams(mesh));
      }),
      { numRuns: 150 },
    );
  });
});

describe('random characters', () => {
  it('are the same when written and read again, weights and all', async () => {
    await fc.assert(
      fc.asyncProperty(skinnedParts, async (parts) => {
        const character = built(parts);
        const { files, losses } = writeMit(character);
        expect(losses).toEqual([]);
        const again = await readOne(Object.fromEntries(files.map((f) => [f.path, f.bytes])));
        expect(again.skeleton).toEqual(character.skeleton);
        expect(again.skin).toEqual(character.skin);
        expect(withoutSeams(again.mesh)).toEqual(withoutSeams(character.mesh));
      }),
      { numRuns: 150 },
    );
  });

  it('give GPUs no number that they flush', () => {
    const angle = fc.double({ min: -4, max: 4, noNaN: true });
    fc.assert(
      fc.property(skinnedParts, fc.array(angle, { minLength: 63, maxLength: 63 }), (parts, q) => {
        const character = built(parts);
        const { mesh, skeleton } = character;
        const pose = { q: skeleton.qRest.map((_, i) => q[i]!) };
        for (const skin of [character.skin, normalizeSkin(character.skin)]) {
          for (const method of loadedKernels) {
            const palette = new Float32Array(skeleton.jointCount * method.vec4sPerEntry(skin) * 4);
            method.packPalette(skin, jointMatrices(skeleton, pose.q), palette);
            const { positions, normals } = skinVertices(character, skin, pose, method);
            expectNoSubnormals({ palette, positions, normals, weights: skin.weights });
          }
        }
        const { positions, normals, uvs } = mesh;
        expectNoSubnormals({ positions, normals, uvs: uvs ?? new Float32Array(0) });
        expect(
          character.skin.weights.every((weight) => Math.abs(weight) >= Math.fround(1e-6)),
        ).toBe(true);
      }),
      { numRuns: 100 },
    );
  });
});

function expectNoSubnormals(arrays: Readonly<Record<string, Float32Array>>): void {
  for (const [name, values] of Object.entries(arrays)) {
    const subnormal = values.find((value) => value !== 0 && Math.abs(value) < 2 ** -126);
    if (subnormal !== undefined) expect.fail(`${name} hold ${subnormal}`);
  }
}
