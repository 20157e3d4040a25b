import { expect, it } from 'vitest';
import { measureMethod } from './measure-method.ts';
import { handsAndFeet, leg, sixBalls } from './ik-rigs.ts';

// `npm run test:long -- ik --targets 200` sets how many targets each set-up gets.
const count = Number(process.env['IK_TARGETS'] ?? 60);

it.each([
  ['a chain of six balls within ±0.7', sixBalls],
  ['a leg whose one-sided knee starts straight', leg],
  ['both hands at once, the feet pinned', handsAndFeet],
] as const)('damped least squares reaches targets within the limits: %s', async (_, rigOf) => {
  const { solved, beyondLimits } = await measureMethod('dls', await rigOf(), count);
  expect(solved).toBeGreaterThanOrEqual(Math.ceil(0.99 * count));
  expect(beyondLimits).toBe(0);
});

it.each(['ccd', 'fabrik'] as const)('%s keeps the limits too', async (id) => {
  const { solved, beyondLimits } = await measureMethod(id, leg(), 20);
  expect(solved).toBeGreaterThan(0);
  expect(beyondLimits).toBe(0);
});
