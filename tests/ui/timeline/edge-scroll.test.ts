import { describe, expect, it } from 'vitest';
import { edgeSpeed } from '../../../src/ui/timeline/edge-scroll.ts';

describe('the speed at which a drag scrolls', () => {
  it('is 0 inside of the view', () => {
    for (const place of [20, 150, 280]) expect(edgeSpeed(place, 300)).toBe(0);
  });

  it('grows toward and beyond an edge, in its direction', () => {
    const ends = [290, 300, 340, 400].map((place) => edgeSpeed(place, 300));
    expect(ends.every((speed, at) => speed > (ends[at - 1] ?? 0))).toBe(true);
    const starts = [10, 0, -40, -100].map((place) => edgeSpeed(place, 300));
    expect(starts).toEqual(ends.map((speed) => -speed));
  });

  it('no more grows far from the view', () => {
    expect(edgeSpeed(5000, 300)).toBe(edgeSpeed(1000, 300));
    expect(edgeSpeed(-5000, 300)).toBe(edgeSpeed(-1000, 300));
  });
});
