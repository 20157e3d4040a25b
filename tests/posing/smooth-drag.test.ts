import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { beginDrag } from '../../src/posing/drag.ts';
import { transform, unit } from '../reference/matrix.ts';
import { largestDifference } from '../support/compare.ts';
import { dot, dragRig, startOver, turningKinds, worldOf } from './drag-rigs.ts';

const seeds = fc.nat(1e6);
const held = [0.3, 0.4, -0.1] as const;

describe('a drag goes smoothly', () => {
  it('with the nearest of the two quaternions of a ball', () => {
    fc.assert(
      fc.property(seeds, fc.boolean(), (seed, isNegated) => {
        const rig = dragRig('b', seed);
        const { start, view } = startOver(rig, held, seed + 1);
        const drag = beginDrag({ ...start, mode: { kind: 'follow' } });
        // The same pose with the other of its two quaternions.
        const present = rig.q.map((value, i) => (isNegated && i >= 4 ? -value : value));
        const { x, y } = start.pointer;
        const next = drag.move(view.pointerAt(x + 5, y), present);
        const product = next.subarray(4).map((value, i) => value * present[4 + i]!);
        expect(product.reduce((sum, value) => sum + value)).toBeGreaterThan(0.9);
      }),
    );
  });

  it.each([...turningKinds, 'x', 's'])('from a point beside the pointer: "%s"', (kind) => {
    fc.assert(
      fc.property(seeds, (seed) => {
        const rig = dragRig(kind, seed);
        const { start, view } = startOver(rig, held, seed + 1);
        const { x, y } = start.pointer;
        const mode =
          kind === 's' || kind === 'x'
            ? ({ kind: 'value', index: 4 } as const)
            : ({ kind: 'follow' } as const);
        const drag = beginDrag({ ...start, pointer: view.pointerAt(x + 15, y - 9), mode });
        const q = drag.move(view.pointerAt(x + 15 + 1e-6, y - 9));
        const moved = transform(worldOf(rig, q), held);
        expect(largestDifference(moved, start.grabbed)).toBeLessThan(1e-3);
      }),
    );
  });

  it('about an axis seen from the side, with the point on the side where it began', () => {
    fc.assert(
      fc.property(seeds, fc.boolean(), (seed, isNear) => {
        const rig = dragRig('z', seed);
        const world = worldOf(rig, rig.q);
        // Straight across the hinge: apart from perspective, its circle is a line in the picture.
        const away = unit(world.slice(0, 3).map((row) => row[0]!));
        const point = [isNear ? 0.3 : -0.3, 0.1, 0];
        const { start, view, pivot } = startOver(rig, point, 0, away);
        const drag = beginDrag({ ...start, mode: { kind: 'value', index: 4 } });
        for (const aside of [-0.2, -0.1, 0, 0.05, 0.25]) {
          // At a point of the same circle, with the pointer slightly off.
          const over = [(isNear ? 1 : -1) * Math.sqrt(0.1 - aside * aside), aside, 0];
          const { x, y } = view.pointerOver(transform(world, over));
          const q = drag.move(view.pointerAt(x, y + 1e-3));
          const toEye = transform(worldOf(rig, q), point).map((v, i) => v - pivot[i]!);
          expect(dot(toEye, away) > 0).toBe(isNear);
        }
      }),
      { numRuns: 40 },
    );
  });
});
