import { describe, expect, it } from 'vitest';
import { type EulerProduct, extractEuler } from '../../src/core/euler.ts';
import { type Matrix, multiply, rotationAbout } from '../reference/matrix.ts';
import { columnMajor, largestDifference } from '../support/compare.ts';
import { randomBetween, randomSource } from '../support/random.ts';

const axes = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
] as const;

function product(kind: EulerProduct, angles: readonly number[]): Matrix {
  const turns = axes.map((axis, i) => rotationAbout(axis, angles[i]!));
  return (kind === 'xyz' ? turns : turns.toReversed()).reduce(multiply);
}

const products: readonly EulerProduct[] = ['xyz', 'zyx'];

describe.each(products)('angles of the product %s', (kind) => {
  const extract = (angles: readonly number[], near: readonly number[]) =>
    extractEuler(columnMajor(product(kind, angles)), kind, near);

  it('give the rotation again, and the angles themselves where they are near', () => {
    const random = randomSource(169);
    for (let i = 0; i < 2000; i++) {
      const angles = [0, 1, 2].map(() => randomBetween(random, -9, 9));
      const again = extract(angles, [0, 0, 0]);
      expect(
        largestDifference(product(kind, again).flat(), product(kind, angles).flat()),
      ).toBeLessThan(1e-9);
      const near = angles.map((angle) => angle + randomBetween(random, -0.01, 0.01));
      if (Math.abs(Math.cos(angles[1]!)) > 0.05) {
        expect(largestDifference(extract(angles, near), angles)).toBeLessThan(1e-9);
      }
    }
  });

  it.each([1, -1])('keep z at the gimbal, and put the rest in x: y = %d · π/2', (side) => {
    const angles = [0.4, (side * Math.PI) / 2, -1.1];
    const again = extract(angles, [0, 0, 0.7]);
    expect(again[2]).toBe(0.7);
    expect(
      largestDifference(product(kind, again).flat(), product(kind, angles).flat()),
    ).toBeLessThan(1e-9);
    expect(largestDifference(extract(angles, angles), angles)).toBeLessThan(1e-9);
  });
});
