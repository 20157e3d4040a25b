import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { normalizeSkin } from '../../../src/core/skin.ts';
import { createActor } from '../../../src/document/scene.ts';
import { compareWith, type MethodNumbers } from '../../../src/evaluation/comparison/compare.ts';
import { differenceOf, sizeOf } from '../../../src/evaluation/comparison/difference.ts';
import { rowSumDifference, rowSumsOf } from '../../../src/evaluation/comparison/row-sums.ts';
import { Evaluator } from '../../../src/evaluation/evaluator.ts';
import { linearBlend } from '../../../src/skinning/linear-blend.ts';
import { characterOfRig, qOfValues } from '../../fixtures/character-of-rig.ts';
import type { Rig } from '../../fixtures/rig.ts';
import { randomValues, rotatedTree } from '../../fixtures/rigs.ts';
import { twistingTube } from '../../fixtures/twisting-tube.ts';
import { fullPool } from '../../support/kernels.ts';
import { skinVertices } from '../../support/skin-vertices.ts';

describe('the difference of two posed meshes', () => {
  it('has the distance of each point, the largest with its point, and the mean', () => {
    const base = Float32Array.of(0, 0, 0, 1, 1, 1, 5, 5, 5, 9, 9, 9);
    const posed = Float32Array.of(0, 0, 0, 4, 5, 1, 5, 5, 6, 0, 0, 0);
    // The fourth triple is a render vertex and not a point.
    const { distances, ...numbers } = differenceOf(posed, base, 3);
    expect([...distances]).toEqual([0, 5, 1]);
    expect(numbers).toEqual({ largest: 5, worst: 1, mean: 2 });
    expect(differenceOf(posed, base, 3, 1).mean).toBeCloseTo(5 / 3, 12);
    expect(differenceOf(posed, base, 0)).toMatchObject({ largest: 0, mean: 0 });
  });

  it('is as long one way as the other, and nothing to itself', () => {
    const floats = fc.float32Array({ noNaN: true, noDefaultInfinity: true, min: -9, max: 9 });
    fc.assert(
      fc.property(floats, floats, (a, b) => {
        const count = Math.floor(Math.min(a.length, b.length) / 3);
        expect(differenceOf(a, b, count)).toEqual(differenceOf(b, a, count));
        expect(differenceOf(a, a, count).largest).toBe(0);
      }),
    );
  });

  it('is a part of the height, or of the size of what is flat', () => {
    const bounds = (max: readonly number[]) => ({
      bounds: { min: new Float64Array(3), max: Float64Array.from(max) },
    });
    expect(sizeOf(bounds([3, 2, 4]))).toEqual({ height: 2, diagonal: Math.hypot(3, 2, 4) });
    expect(sizeOf(bounds([3, 0, 4]))).toEqual({ height: 5, diagonal: 5 });
  });
});

describe('methods that differ by rounding alone', () => {
  it('do not differ, as in the page', async () => {
    const tube = await twistingTube();
    const pool = fullPool();
    const evaluations = (['linear-blend', 'delta-mush'] as const).map((method) => {
      const actor = createActor(1, tube, method);
      return new Evaluator(actor, pool).evaluate(actor, 0);
    });
    const [base, mushed] = evaluations.map((evaluation) => evaluation.vertices().positions);
    expect(differenceOf(mushed!, base!, tube.mesh.pointCount).largest).toBeGreaterThan(0);
    const [, { difference }] = compareWith(evaluations[0]!, evaluations) as [
      unknown,
      MethodNumbers,
    ];
    expect(difference).toMatchObject({ largest: 0, worst: 0, mean: 0 });
  });
});

describe('the part of a difference that is due to sums of rows', () => {
  const plain = rotatedTree();
  const factors = [1, 0.9, 1.2];
  const rig: Rig = {
    ...plain,
    rows: plain.rows.map((row, point) => {
      const total = row.reduce((sum, [, weight]) => sum + weight, 0);
      const factor = factors[point % 3]! / total;
      return row.map(([joint, weight]) => [joint, weight * factor] as const);
    }),
  };
  const character = characterOfRig(rig);
  const q = qOfValues(character.skeleton, randomValues(rig, 17));

  it('names the rows that do not sum to 1', () => {
    const sums = rowSumsOf(character.skin)!;
    expect(sums.count).toBe(rig.points.filter((_, point) => point % 3 > 0).length);
    expect(sums.worst % 3).toBe(2);
    expect(sums.worstSum).toBeCloseTo(1.2, 6);
    expect(rowSumsOf(normalizeSkin(character.skin))).toBeNull();
  });

  it('is that of the same method by normalized rows', () => {
    const actor = createActor(1, character, 'linear-blend', { q });
    const found = rowSumDifference(new Evaluator(actor).evaluate(actor, 0))!;
    const pose = { q };
    const raw = skinVertices(character, character.skin, pose, linearBlend).positions;
    const normalized = normalizeSkin(character.skin);
    const { positions } = skinVertices(character, normalized, pose, linearBlend);
    const expected = differenceOf(raw, positions, character.mesh.pointCount);
    expect(found.largest).toBeCloseTo(expected.largest, 6);
    expect(found.worst).toBe(expected.worst);
    expect([...found.distances.filter((_, point) => point % 3 === 0)].every((d) => d === 0)).toBe(
      true,
    );
    expect(found.largest).toBeGreaterThan(0.01 * sizeOf(character).diagonal);
  });

  it('is null where the rows are normalized', () => {
    const actor = createActor(1, character, 'linear-blend', { q, normalizeWeights: true });
    expect(rowSumDifference(new Evaluator(actor).evaluate(actor, 0))).toBeNull();
  });
});
