import { describe, expect, it } from 'vitest';
import { formatDegrees, parseTyped } from '../../src/ui/angle-text.ts';

describe('typed numbers', () => {
  it.each([
    ['1.5', 1.5],
    [' -.25 ', -0.25],
    ['4', 4],
    ['1e-3', 0.001],
    ['90°', Math.PI / 2],
    ['-45 deg', -Math.PI / 4],
    ['180DEG', Math.PI],
  ])('%s is %d', (text, value) => expect(parseTyped(text)).toBeCloseTo(value, 12));

  it.each(['', '-', 'x', '1,5', '1.2.3', '90 degrees', 'Infinity', '0x10'])(
    '"%s" is no number',
    (text) => expect(parseTyped(text)).toBeNaN(),
  );

  it('shows degrees to a tenth, and no negative zero', () => {
    expect([Math.PI / 2, -0.0001, 1].map(formatDegrees)).toEqual(['90°', '0°', '57.3°']);
  });
});
