import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { influencesOf, type Skin } from '../../src/core/skin.ts';
import { keepInfluences, strongestInfluences } from '../../src/core/strongest-influences.ts';
import { influencesLost } from '../../src/formats/influences-lost.ts';

const rowOf = (...weights: readonly number[]) =>
  weights.map((weight, entry) => ({ entry, weight }));

function skinOf(...rows: readonly (readonly number[])[]): Skin {
  const weights = rows.flat();
  const start = rows.reduce((starts, row) => [...starts, starts.at(-1)! + row.length], [0]);
  return {
    start: Uint32Array.from(start),
    entries: Uint16Array.from(weights, (_, i) => i),
    weights: Float32Array.from(weights),
    paletteJoint: Uint16Array.from(weights, (_, i) => i),
    jointFromBind: new Float64Array(weights.length * 16),
    normals: 'blended',
  };
}

describe('strongestInfluences', () => {
  it('keeps the largest weights, the largest first, with the sum of all', () => {
    expect(strongestInfluences(rowOf(0.125, 0.5, 0.25, 0.125), 2)).toEqual([
      { entry: 1, weight: 0.5 / 0.75 },
      { entry: 2, weight: 0.25 / 0.75 },
    ]);
  });

  it('keeps the sum of any row of positive weights, and rows that are short enough', () => {
    const weights = fc.array(fc.double({ min: 1e-6, max: 1, noNaN: true }), { minLength: 1 });
    fc.assert(
      fc.property(weights, fc.integer({ min: 1, max: 4 }), (values, most) => {
        const row = rowOf(...values);
        const kept = strongestInfluences(row, most);
        if (row.length <= most) expect(kept).toBe(row);
        else expect(kept).toHaveLength(most);
        const sum = (each: typeof kept) => each.reduce((total, { weight }) => total + weight, 0);
        expect(sum(kept) / sum(row)).toBeCloseTo(1, 12);
      }),
    );
  });

  it('compares weights without their signs, and keeps the earlier of equal ones', () => {
    expect(strongestInfluences(rowOf(0.5, -0.75, 0.5, 0.75), 2).map(({ entry }) => entry)).toEqual([
      1, 3,
    ]);
    expect(strongestInfluences(rowOf(0.25, 0.25, 0.25, 0.25), 1)).toEqual([
      { entry: 0, weight: 1 },
    ]);
  });

  it('does not scale weights that cancel each other', () => {
    expect(strongestInfluences(rowOf(0.5, -0.5, 0.25), 2)).toEqual(rowOf(0.5, -0.5));
  });
});

describe('keepInfluences', () => {
  it('shortens long rows alone, to the same sums and strongest weights', () => {
    const weight = fc.float({ min: Math.fround(0.01), max: 1, noNaN: true });
    const rows = fc.array(fc.array(weight, { minLength: 1, maxLength: 9 }), { maxLength: 12 });
    fc.assert(
      fc.property(rows, fc.integer({ min: 1, max: 8 }), (given, most) => {
        const skin = skinOf(...given);
        const kept = keepInfluences(skin, most);
        given.forEach((row, point) => {
          const before = influencesOf(skin, point);
          const after = influencesOf(kept, point);
          expect(after).toHaveLength(Math.min(most, row.length));
          if (row.length <= most) expect(after).toEqual(before);
          const sum = (influences: typeof after) =>
            influences.reduce((total, each) => total + each.weight, 0);
          expect(sum(after) / sum(before)).toBeCloseTo(1, 6);
          // Nothing that was dropped was stronger than something that was kept.
          const entries = new Set(after.map(({ entry }) => entry));
          const weakest = Math.min(
            ...before.filter(({ entry }) => entries.has(entry)).map((each) => each.weight),
          );
          for (const { entry, weight: dropped } of before) {
            if (!entries.has(entry)) expect(dropped).toBeLessThanOrEqual(weakest);
          }
        });
      }),
      { numRuns: 50 },
    );
  });
});

describe('influencesLost', () => {
  it('counts the points and has the largest part of the weights of any', () => {
    const skin = skinOf([0.5, 0.5], [0.5, 0.25, 0.25], [0.5, 0.375, 0.125], [1]);
    expect(influencesLost(skin, 2)).toEqual({ pointCount: 2, largestShare: 0.25 });
    expect(influencesLost(skin, Infinity)).toEqual({ pointCount: 0, largestShare: 0 });
  });
});
