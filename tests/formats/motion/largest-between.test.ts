import fc from 'fast-check';
import { expect, it } from 'vitest';
import { atMost, largestBetween } from '../../../src/formats/motion/largest-between.ts';

it('finds the largest of a smooth difference wherever it is between times', () => {
  fc.assert(
    fc.property(fc.double({ min: 2.02, max: 2.98, noNaN: true }), (peak) => {
      const found = largestBetween([0, 1, 2, 3], (time) => 0.7 / (1 + 9 * (time - peak) ** 2));
      expect(found).toBeCloseTo(0.7, 6);
    }),
  );
  expect(largestBetween([0, 1], () => 0)).toBe(0);
  expect(largestBetween([4], () => 1)).toBe(0);
});

it('rounds up to two digits', () => {
  expect([0, 0.561, 0.56, 0.999, 12.1, 3.0001e-7].map(atMost)).toEqual([
    ...[0, 0.57, 0.56, 1, 13, 3.1e-7],
  ]);
  fc.assert(
    fc.property(fc.double({ min: 1e-12, max: 1e6, noNaN: true }), (value) => {
      expect(atMost(value)).toBeGreaterThanOrEqual(value);
      expect(atMost(value)).toBeLessThan(value * 1.11);
    }),
  );
});
