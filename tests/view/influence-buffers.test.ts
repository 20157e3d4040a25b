import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type Skin, skinWithRows } from '../../src/core/skin.ts';
import { Gpu } from '../../src/gl/gpu.ts';
import { Pool } from '../../src/gl/pool.ts';
import { createInfluenceBuffers, type InfluenceBuffers } from '../../src/view/influence-buffers.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { allRigs, manyInfluences, rotatedTree } from '../fixtures/rigs.ts';
import { FakeGl } from './fake-gl.ts';

/** Multiplies the weights of some points; their entries stay the same. */
function scaled(skin: Skin, points: readonly number[], factor: number): Skin {
  const start = [0];
  const entries: number[] = [];
  const weights: number[] = [];
  for (const point of points) {
    for (let i = skin.start[point]!; i < skin.start[point + 1]!; i++) {
      entries.push(skin.entries[i]!);
      weights.push(skin.weights[i]! * factor);
    }
    start.push(weights.length);
  }
  return skinWithRows(skin, points, { start, entries, weights });
}

function contentsOf({ buffers, textures }: FakeGl): unknown {
  return [buffers.map(({ bytes }) => bytes), textures.map(({ texels }) => texels)];
}

describe('influences on the GPU', () => {
  it('change to those of another skin by sending only the rows that differ', () => {
    const { mesh, skin } = characterOfRig(rotatedTree());
    const gl = new FakeGl();
    const buffers = createInfluenceBuffers(new Gpu(gl.context), mesh, skin);
    gl.uploadedBytes = 0;
    expect(buffers.patch(skin, scaled(skin, [3, 4, 9], 0.5))).toBe(true);
    const vertices = [...mesh.pointOf].filter((point) => [3, 4, 9].includes(point)).length;
    expect(gl.uploadedBytes).toBe(vertices * buffers.pairs * 4 * Float32Array.BYTES_PER_ELEMENT);
  });

  it('do so in a texture too', () => {
    const { mesh, skin } = characterOfRig(manyInfluences());
    const gl = new FakeGl();
    const buffers = createInfluenceBuffers(new Gpu(gl.context), mesh, skin);
    expect(buffers.texture).not.toBeNull();
    gl.uploadedBytes = 0;
    expect(buffers.patch(skin, scaled(skin, [2], 0.5))).toBe(true);
    expect(gl.uploadedBytes).toBe((skin.start[3]! - skin.start[2]!) * 8);
  });

  it('are then equal to newly created ones, whatever rows differ', () => {
    const characters = Object.values(allRigs).map((rig) => characterOfRig(rig()));
    const change = fc.tuple(fc.nat(1000), fc.constantFrom(0.5, 2));
    fc.assert(
      fc.property(
        fc.nat(characters.length - 1),
        fc.boolean(),
        fc.array(change, { maxLength: 8 }),
        (which, forceTexture, changes) => {
          const { mesh, skin } = characters[which]!;
          const [patched, made] = [new FakeGl(), new FakeGl()];
          const buffers = createInfluenceBuffers(
            new Gpu(patched.context),
            mesh,
            skin,
            forceTexture,
          );
          let held = skin;
          for (const [point, factor] of changes) {
            const next = scaled(held, [point % mesh.pointCount], factor);
            expect(buffers.patch(held, next)).toBe(true);
            held = next;
          }
          createInfluenceBuffers(new Gpu(made.context), mesh, held, forceTexture);
          expect(contentsOf(patched)).toEqual(contentsOf(made));
        },
      ),
      { numRuns: 50 },
    );
  });

  it('are created again if a row becomes longer or shorter', () => {
    const { mesh, skin } = characterOfRig(rotatedTree());
    const buffers = createInfluenceBuffers(new Gpu(new FakeGl().context), mesh, skin);
    const shorter = skinWithRows(skin, [0], { start: [0, 1], entries: [1], weights: [1] });
    expect(buffers.patch(skin, shorter)).toBe(false);
  });

  it('do not change for others that hold them', () => {
    const { mesh, skin } = characterOfRig(rotatedTree());
    const gpu = new Gpu(new FakeGl().context);
    const pool = new Pool<Skin, InfluenceBuffers>();
    const lease = (key: Skin) => pool.lease(key, () => createInfluenceBuffers(gpu, mesh, key));
    const other = scaled(skin, [1], 0.5);
    const convert = (from: Skin, to: Skin) =>
      pool.convert(from, to, (buffers) => buffers.patch(from, to));
    const [first, second] = [lease(skin), lease(skin)];
    expect(convert(skin, other)).toBe(false);
    second.release();
    expect(convert(skin, other)).toBe(true);
    expect(lease(other).value).toBe(first.value);
    expect(pool.has(skin)).toBe(false);
  });
});
