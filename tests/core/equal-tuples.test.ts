import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { cpuTime } from '../support/cpu-time.ts';
import { firstEqualFloats, firstEqualTuples } from '../../src/core/equal-tuples.ts';

/** The oracle: compares each tuple with all before it. */
function byComparing(tuples: readonly (readonly number[])[]): number[] {
  return tuples.map((tuple) =>
    tuples.findIndex((other) => other.every((value, i) => value === tuple[i])),
  );
}

describe('firstEqualTuples', () => {
  it('finds for each tuple the first that equals it', () => {
    const value = fc.oneof(fc.nat(3), fc.integer());
    const tuples = fc
      .integer({ min: 1, max: 4 })
      .chain((size) => fc.array(fc.array(value, { minLength: size, maxLength: size })));
    fc.assert(
      fc.property(tuples, (list) => {
        const size = list[0]?.length ?? 1;
        const found = firstEqualTuples(Int32Array.from(list.flat()), size);
        expect([...found]).toEqual(byComparing(list));
      }),
    );
  });

  it('probes about as many slots as there are tuples, for grids and for one shared element', async () => {
    // Like meshes: consecutive numbers, one point in many corners, all tuples equal.
    const patterns = [
      (i: number) => [i, i, i],
      (i: number) => [7, i, 0],
      (i: number) => [i % 300, Math.floor(i / 300), 5],
      (i: number) => [i << 16, 0, i << 8],
    ];
    for (const pattern of patterns) {
      const values = Int32Array.from(Array.from({ length: 60_000 }, (_, i) => pattern(i)).flat());
      expect(firstEqualTuples(values, 3).every((first, i) => first === i)).toBe(true);
      // About 20 times the usual time; a long run of occupied slots would take many times longer.
      expect(await cpuTime(() => firstEqualTuples(values, 3))).toBeLessThan(500);
    }
  });
});

describe('firstEqualFloats', () => {
  it('treats 0 and -0 as equal', () => {
    expect([...firstEqualFloats(Float32Array.of(0, 1, -0, 1, 0.5, 1), 2)]).toEqual([0, 0, 2]);
  });
});
