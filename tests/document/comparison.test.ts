import { describe, expect, it } from 'vitest';
import { comparisonOf, withMethods, withWipe } from '../../src/document/comparison.ts';

describe('a comparison', () => {
  it('gives each method the same width at first, and again for another number of methods', () => {
    const two = comparisonOf(['own', 'rigid']);
    expect(two.wipes).toEqual([0.5]);
    const moved = withWipe(two, 0, 0.7);
    expect(withMethods(moved, ['own', 'delta-mush']).wipes).toEqual([0.7]);
    expect(withMethods(moved, ['own', 'rigid', 'delta-mush']).wipes).toEqual([1 / 3, 2 / 3]);
  });

  it('moves a wipe no farther than the two beside it', () => {
    const three = comparisonOf(['own', 'rigid', 'delta-mush']);
    expect(withWipe(three, 0, 0.9).wipes).toEqual([2 / 3, 2 / 3]);
    expect(withWipe(three, 1, -3).wipes).toEqual([1 / 3, 1 / 3]);
    expect(withWipe(three, 1, 7).wipes).toEqual([1 / 3, 1]);
  });

  it('counts differences from the same method while it is there, else from the first', () => {
    const three = { ...comparisonOf(['own', 'rigid', 'delta-mush']), base: 1 };
    expect(withMethods(three, ['rigid', 'own']).base).toBe(0);
    expect(withMethods(three, ['own', 'delta-mush']).base).toBe(0);
  });
});
