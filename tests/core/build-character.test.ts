import { describe, expect, it } from 'vitest';
import { bonesOf } from '../../src/core/bones.ts';
import { diagonal, emptyBounds, includePositions, isEmpty } from '../../src/core/bounds.ts';
import { buildCharacter } from '../../src/core/build-character.ts';
import { partsOfRig } from '../fixtures/character-of-rig.ts';
import { rotatedTree } from '../fixtures/rigs.ts';

const { skeleton, mesh, skin } = partsOfRig(rotatedTree());
const common = { name: 'a', missing: [] };
const brokenSkeleton = {
  file: 'a.skel',
  joints: [{ name: 'a', parent: 0, restOffset: [0, 0, 0] as const, dofs: [] }],
};

describe('buildCharacter', () => {
  it('gives nothing where there is neither skeleton nor mesh', () => {
    expect(buildCharacter({ ...common, skin: skin! })).toEqual({ diagnostics: [] });
  });

  it('shows a skeleton without mesh', () => {
    const { value } = buildCharacter({ ...common, skeleton: skeleton!, skin: skin! });
    expect(value).toMatchObject({ skeleton: { jointCount: 9 }, mesh: { pointCount: 0 } });
    expect(bonesOf(value!).length).toBeGreaterThan(0);
    expect(isEmpty(value!.bounds)).toBe(false);
  });

  it('shows a mesh without a skeleton, which never moves', () => {
    const { value } = buildCharacter({ ...common, mesh: mesh!, skin: skin! });
    expect(value).toMatchObject({ skeleton: { jointCount: 0 }, mesh: { pointCount: 62 } });
    expect(value!.skin.weights.every((weight) => weight === 1)).toBe(true);
  });

  it('shows the mesh where the skeleton has an error', () => {
    const parts = { ...common, mesh: mesh!, skin: skin!, skeleton: brokenSkeleton };
    const { value, diagnostics } = buildCharacter(parts);
    expect(value).toMatchObject({ skeleton: { jointCount: 0 }, mesh: { pointCount: 62 } });
    expect(diagnostics).toMatchObject([{ severity: 'error', code: 'character/root' }]);
  });

  it('gives nothing if every part has an error', () => {
    const { value, diagnostics } = buildCharacter({ ...common, skeleton: brokenSkeleton });
    expect(value).toBeUndefined();
    expect(diagnostics).toHaveLength(1);
  });
});

describe('bounds', () => {
  it('contain all positions, and have no size while empty', () => {
    const bounds = emptyBounds();
    expect(isEmpty(bounds)).toBe(true);
    expect(diagonal(bounds)).toBe(0);
    includePositions(bounds, [1, 5, 3, -2, 1, 3, 100, 100, 100], 2);
    expect([...bounds.min, ...bounds.max]).toEqual([-2, 1, 3, 1, 5, 3]);
    expect(diagonal(bounds)).toBe(5);
  });
});
