import { expect, test } from 'vitest';
import { colorDifference, labOf, type Lab } from '../../src/core/color-difference.ts';

// The measure by which the first picture is judged must itself be right.
test('pairs that the authors of the formula publish have their differences', () => {
  const pairs: [Lab, Lab, number][] = [
    [[50, 2.6772, -79.7751], [50, 0, -82.7485], 2.0425],
    [[50, 2.5, 0], [50, 0, -2.5], 4.3065],
    [[50, 2.5, 0], [73, 25, -18], 27.1492],
    [[63.0109, -31.0961, -5.8663], [62.8187, -29.7946, -4.0864], 1.263],
    [[22.7233, 20.0904, -46.694], [23.0331, 14.973, -42.5619], 2.0373],
    [[2.0776, 0.0795, -1.135], [0.9033, -0.0636, -0.5514], 0.9082],
  ];
  for (const [first, second, expected] of pairs) {
    expect(colorDifference(first, second)).toBeCloseTo(expected, 4);
    expect(colorDifference(second, first)).toBeCloseTo(expected, 4);
  }
});

test('grays have no color, and primaries have their known places', () => {
  for (const [index, value] of labOf([255, 255, 255]).entries()) {
    expect(value).toBeCloseTo([100, 0, 0][index]!, 1);
  }
  for (const [index, value] of labOf([255, 0, 0]).entries()) {
    expect(value).toBeCloseTo([53.24, 80.09, 67.2][index]!, 1);
  }
  expect(colorDifference([40, 0, 0], [40, 0, 0])).toBe(0);
});
