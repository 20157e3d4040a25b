import { describe, expect, it } from 'vitest';
import { ancestorsOf, visibleRows } from '../../src/ui/joint-rows.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { allRigs } from '../fixtures/rigs.ts';

describe.each(Object.entries(allRigs).map(([name, rig]) => ({ name, rig })))(
  'the tree of $name',
  ({ rig }) => {
    const { skeleton } = characterOfRig(rig());
    const all = Array.from({ length: skeleton.jointCount }, (_, joint) => joint);

    it('shows every joint once, one level below its parent and after it', () => {
      const rows = visibleRows(skeleton, new Set(), '');
      expect(rows.map(({ joint }) => joint)).toEqual(all);
      const levels = new Map(rows.map(({ joint, level }) => [joint, level]));
      for (const joint of all) {
        const parent = skeleton.parents[joint]!;
        expect(levels.get(joint)).toBe(parent < 0 ? 1 : levels.get(parent)! + 1);
      }
    });

    it('hides only the descendants of a folded joint', () => {
      for (const folded of all) {
        const shown = new Set(
          visibleRows(skeleton, new Set([folded]), '').map(({ joint }) => joint),
        );
        for (const joint of all) {
          expect(shown.has(joint)).toBe(!ancestorsOf(skeleton, joint).includes(folded));
        }
      }
    });

    it('finds joints by a part of their name in any case, folded or not', () => {
      const name = skeleton.names[skeleton.jointCount - 1]!;
      const found = visibleRows(skeleton, new Set(all), name.toUpperCase());
      expect(found.map(({ joint }) => joint)).toContain(skeleton.jointCount - 1);
      expect(visibleRows(skeleton, new Set(), 'no such name')).toEqual([]);
    });
  },
);
