import { expect, it } from 'vitest';
import { spreadHeights } from '../../../src/ui/vertex-inspector/ghost-labels.ts';

it('labels that would overlap move down, in their order, and others stay', () => {
  expect(spreadHeights([100, 40, 102, 108], 18)).toEqual([100, 40, 118, 136]);
  expect(spreadHeights([], 18)).toEqual([]);
});
