import { expect, it } from 'vitest';
import { spreadHeights, standsLeft } from '../../../src/ui/vertex-inspector/ghost-labels.ts';

it('labels that would overlap move down, in their order, and others stay', () => {
  expect(spreadHeights([100, 40, 102, 108], 18)).toEqual([100, 40, 118, 136]);
  expect(spreadHeights([], 18)).toEqual([]);
});

it('names stand away from the vertex, and from a figure beside it, where there is room', () => {
  expect(standsLeft({ x: 0.4, isLeft: true }, 600, null)).toBe(true);
  expect(standsLeft({ x: 0.6, isLeft: false }, 600, null)).toBe(false);
  expect(standsLeft({ x: 0.6, isLeft: false }, 600, 'right')).toBe(true);
  expect(standsLeft({ x: 0.4, isLeft: true }, 600, 'left')).toBe(false);
  expect(standsLeft({ x: 0.1, isLeft: true }, 600, 'right')).toBe(false);
  expect(standsLeft({ x: 0.9, isLeft: false }, 600, 'left')).toBe(true);
});
