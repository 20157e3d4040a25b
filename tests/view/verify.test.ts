import { describe, expect, it } from 'vitest';
import { createActor } from '../../src/document/scene.ts';
import type { VertexStreams } from '../../src/skinning/method.ts';
import { loadedKernel } from '../support/kernels.ts';
import { skinVertices } from '../support/skin-vertices.ts';
import { verifySkin } from '../../src/view/verify.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { allRigs } from '../fixtures/rigs.ts';

const character = characterOfRig(Object.values(allRigs)[0]!());
const state = createActor(1, character, 'linear-blend');
const { q } = state;
const posed = skinVertices(character, character.skin, { q }, loadedKernel('linear-blend'));

function changed(change: (streams: VertexStreams) => void): VertexStreams {
  const copy = { positions: posed.positions.slice(), normals: posed.normals.slice() };
  change(copy);
  return copy;
}

describe('verification', () => {
  it('finds equal vertices identical', () => {
    const found = verifySkin(
      state,
      changed(() => undefined),
      posed,
    );
    expect(found).toMatchObject({ position: 0, vertex: 0, normal: 0, identical: true });
  });

  it('names the vertex, counted from one, and the size of the largest difference', () => {
    const found = verifySkin(
      state,
      changed(({ positions }) => (positions[3 * 2 + 1]! += 0.5)),
      posed,
    );
    expect(found.vertex).toBe(3);
    expect(found.position).toBeCloseTo(0.5, 5);
    expect(found.identical).toBe(false);
  });

  it('finds a normal that is the only difference, and a single bit', () => {
    const normal = verifySkin(
      state,
      changed(({ normals }) => (normals[0]! += 0.25)),
      posed,
    );
    expect(normal).toMatchObject({ position: 0, identical: false });
    expect(normal.normal).toBeCloseTo(0.25, 5);
    const zero = changed(({ positions }) => positions.fill(0));
    const negativeZero = changed(({ positions }) => positions.fill(-0));
    expect(verifySkin(state, zero, negativeZero).identical).toBe(false);
  });

  it('treats NaN as the largest possible difference', () => {
    const found = verifySkin(
      state,
      changed(({ positions }) => (positions[4] = NaN)),
      posed,
    );
    expect(found).toMatchObject({ position: Infinity, vertex: 2, identical: false });
  });
});
