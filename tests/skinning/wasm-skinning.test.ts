import { readFileSync } from 'node:fs';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { Character } from '../../src/core/character.ts';
import { jointMatrices } from '../../src/core/forward-kinematics.ts';
import { emptyMesh, type Mesh } from '../../src/core/mesh.ts';
import { noJoint, type Skin } from '../../src/core/skin.ts';
import { plainUse } from '../../src/skinning/method.ts';
import { restMesh } from '../../src/skinning/rest-mesh.ts';
import type { WasmSkinning } from '../../src/skinning/wasm/wasm-skinning.ts';
import { kernelFile } from '../../tools/compile-kernel.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { allRigs, oddWeights, rotatedTree } from '../fixtures/rigs.ts';
import { withMorph } from '../fixtures/with-morph.ts';
import { bitDifferences } from '../support/bit-differences.ts';
import { bundledIds, readBundled } from '../support/bundled.ts';
import { loadedKernel, loadedKernels } from '../support/kernels.ts';
import { randomBetween, randomSource } from '../support/random.ts';
import { compiledSkinning } from '../support/wasm-skinning.ts';

const wasm = await compiledSkinning();
const linearBlend = loadedKernel('linear-blend');
const dualQuaternion = loadedKernel('dual-quaternion');
/** Those that have a plan for the WebAssembly kernel. */
const planned = loadedKernels.filter((method) => method.wasm);

/** Counts differences over some poses of a character, for every method. */
function differencesOf(kernel: WasmSkinning, character: Character, seeds = [51, 52]): number {
  const { skeleton, skin } = character;
  let count = 0;
  for (const seed of seeds) {
    const random = randomSource(seed);
    const q = skeleton.qRest.map((value) => value + randomBetween(random, -1, 1));
    const morphWeights = Float64Array.from(character.morphs, () => random());
    const mesh = restMesh(character, { q, morphWeights });
    const joints = jointMatrices(skeleton, q);
    for (const method of planned) {
      if (!method.wasm!.rows(skin)) continue;
      const palette = new Float32Array(skin.paletteJoint.length * method.vec4sPerEntry(skin) * 4);
      method.packPalette(skin, joints, palette);
      count += bitDifferences(kernel, method, mesh, skin, palette);
    }
  }
  return count;
}

describe('the WebAssembly kernel gives the bits of the strict kernels', () => {
  it.each(Object.entries(allRigs))('for the rig "%s"', (_, makeRig) => {
    expect(differencesOf(wasm, withMorph(characterOfRig(makeRig())))).toBe(0);
  });

  it.each(bundledIds)('for the bundled %s', async (id) => {
    expect(differencesOf(wasm, await readBundled(id), [53])).toBe(0);
  });

  it.each(planned)('for random skins under $id', (method) => {
    fc.assert(
      fc.property(skinned(method.strides[0]!), ({ mesh, skin, palette }) => {
        expect(bitDifferences(wasm, method, mesh, skin, palette)).toBe(0);
      }),
      { numRuns: 150 },
    );
  });

  it('for mixtures of dual quaternions and linear blend', () => {
    const { mesh, skin, skeleton } = characterOfRig(oddWeights());
    const palette = new Float32Array(skin.paletteJoint.length * 20);
    const q = skeleton.qRest.map((value, i) => value + Math.sin(i));
    dualQuaternion.packPalette(skin, jointMatrices(skeleton, q), palette);
    for (const blend of [0, 0.3, 1]) {
      expect(bitDifferences(wasm, dualQuaternion, mesh, skin, palette, { blend })).toBe(0);
    }
    // Nothing has a direction, so all is linear blend.
    for (let entry = 0; entry < palette.length; entry += 20)
      palette.fill(0, entry + 12, entry + 16);
    for (const blend of [0.3, 1]) {
      expect(bitDifferences(wasm, dualQuaternion, mesh, skin, palette, { blend })).toBe(0);
    }
  });

  it('for two meshes that share a skin', () => {
    const { mesh, skin } = characterOfRig(rotatedTree());
    const palette = new Float32Array(skin.paletteJoint.length * 12).fill(0.3);
    const reversed = { ...mesh, pointOf: mesh.pointOf.toReversed() };
    for (const each of [mesh, reversed, mesh]) {
      expect(bitDifferences(wasm, linearBlend, each, skin, palette)).toBe(0);
    }
  });
});

// Equal bits mean something only if the comparison can fail.
describe('the comparison finds a fault in the kernel', () => {
  const faults: Readonly<Record<string, readonly [text: string, faulty: string]>> = {
    'the weight of another vertex': ['load32_splat(at, 12)', 'load32_splat(at, 8)'],
    'a sign in the cofactors': [
      'f32x4.sub(f32x4.mul(a, d), f32x4.mul(b, c))',
      'f32x4.add(f32x4.mul(a, d), f32x4.mul(b, c))',
    ],
    'a sum in another order': [
      'f32x4.add(f32x4.add(f32x4.mul(ax, bx), f32x4.mul(ay, by)), f32x4.mul(az, bz))',
      'f32x4.add(f32x4.mul(ax, bx), f32x4.add(f32x4.mul(ay, by), f32x4.mul(az, bz)))',
    ],
    'rotations that point away from the pivot': ['away ? -0.0 : 0.0', '0.0'],
    'a point that is not relative to its center': [
      'v128.bitselect(f32x4.sub(point, center), point, turns)',
      'point',
    ],
    'a term of the translation': ['minor(y, ez, z, ey)', 'minor(y, ez, z, ex)'],
  };

  // The compiler takes half of the time if it optimizes nothing.
  const quickly = 0;

  it('and none in the good one, compiled as quickly', async () => {
    const kernel = await compiledSkinning(undefined, quickly);
    expect(differencesOf(kernel, characterOfRig(rotatedTree()))).toBe(0);
  });

  it.each(Object.entries(faults))('%s', async (_, [text, faulty]) => {
    const source = readFileSync(kernelFile, 'utf8');
    expect(source.split(text)).toHaveLength(2);
    const kernel = await compiledSkinning(source.replace(text, faulty), quickly);
    expect(differencesOf(kernel, characterOfRig(rotatedTree()))).toBeGreaterThan(0);
  });
});

describe('where the WebAssembly kernel can’t compute', () => {
  const character = characterOfRig(rotatedTree());
  const { mesh } = character;
  const out = { positions: new Float32Array(mesh.vertexCount * 3), normals: null };
  const palette = new Float32Array(character.skin.paletteJoint.length * 12);

  it('it says so for a method without a plan', () => {
    const other = { ...linearBlend, wasm: null };
    expect(wasm.deform(other, mesh, character.skin, palette, out, plainUse)).toBe(false);
  });

  it('it says so for dual quaternions of a skin that stretches', () => {
    const stretched = characterOfRig(allRigs['own binds']!());
    const all = new Float32Array(stretched.skin.paletteJoint.length * 32);
    const { mesh, skin } = stretched;
    const room = { positions: new Float32Array(mesh.vertexCount * 3), normals: null };
    expect(wasm.deform(dualQuaternion, mesh, skin, all, room, plainUse)).toBe(false);
    // Without dual quaternions it is linear blend, of the same palette.
    const none = { extra: undefined, settings: { blend: 0 } };
    expect(wasm.deform(dualQuaternion, mesh, skin, all, room, none)).toBe(true);
  });

  it('it says so for a mesh that is too large for it', () => {
    const huge = { ...mesh, vertexCount: 2 ** 28 };
    expect(wasm.deform(linearBlend, huge, { ...character.skin }, palette, out, plainUse)).toBe(
      false,
    );
  });

  it('compiling rejects bytes that are no kernel', async () => {
    await expect(compiledSkinning('export function (')).rejects.toThrow('ERROR');
  });
});

interface Skinned {
  readonly mesh: Mesh;
  readonly skin: Skin;
  readonly palette: Float32Array;
}

/**
 * Any skin: rows of no influence, of one and of many, negative weights, any sums, render vertices
 * that share points, and numbers that the kernels flush. No sum overflows.
 */
function skinned(vec4sPerEntry: number): fc.Arbitrary<Skinned> {
  const small = fc.constantFrom(0, -0, 1, 1e-45, -1e-40, 1.1e-38, 1.3e-38, 1e-30);
  const number = fc.oneof(fc.float({ noNaN: true, min: -1000, max: 1000 }), small);
  // Smaller weights are dropped when a character is built; the inverse of their sum may be no number.
  const weight = fc
    .oneof(fc.float({ noNaN: true, min: -2, max: 2 }), small)
    .map((value) => (Math.abs(value) < 1e-6 ? 0 : value));
  const numbers = (length: number): fc.Arbitrary<Float32Array> =>
    fc.array(number, { minLength: length, maxLength: length }).map((all) => Float32Array.from(all));
  return fc.integer({ min: 1, max: 5 }).chain((entryCount) => {
    const row = fc.array(fc.tuple(fc.nat(entryCount - 1), weight), { maxLength: 9 });
    const rows = fc.array(row, { minLength: 1, maxLength: 30 });
    return fc.tuple(rows, fc.array(fc.nat(), { maxLength: 6 })).chain(([rows, others]) => {
      const pointOf = Uint32Array.of(...rows.keys(), ...others.map((each) => each % rows.length));
      const start = Uint32Array.of(0, ...rows.map((_, i) => rows.slice(0, i + 1).flat().length));
      const skin: Skin = {
        paletteJoint: new Uint16Array(entryCount).fill(noJoint),
        jointFromBind: Float64Array.from(
          { length: entryCount * 16 },
          (_, i) => +((i % 16) % 5 === 0),
        ),
        start,
        entries: Uint16Array.from(rows.flat(), ([entry]) => entry),
        weights: Float32Array.from(rows.flat(), ([, each]) => each),
        normals: 'blended',
      };
      const [pointCount, vertexCount] = [rows.length, pointOf.length];
      return fc
        .tuple(
          numbers(entryCount * vec4sPerEntry * 4),
          numbers(vertexCount * 3),
          numbers(vertexCount * 3),
        )
        .map(([palette, positions, normals]) => {
          const mesh = { ...emptyMesh, pointCount, vertexCount, pointOf, positions, normals };
          return { mesh, skin, palette };
        });
    });
  });
}
