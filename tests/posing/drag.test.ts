import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { beginDrag, type DragMode } from '../../src/posing/drag.ts';
import { canTurn } from '../../src/posing/joint-frames.ts';
import { transform } from '../reference/matrix.ts';
import { largestDifference } from '../support/compare.ts';
import { tolerances } from '../tolerances.ts';
import { dragRig, startOver, turningKinds, worldOf } from './drag-rigs.ts';

const seeds = fc.nat(1e6);
const pixel = fc.double({ min: -350, max: 350, noNaN: true });
const limits = fc.tuple(
  fc.double({ min: -1.5, max: 0, noNaN: true }),
  fc.double({ min: 0, max: 1.5, noNaN: true }),
);
const allKinds = [...turningKinds, 'x', 'y', 'xy', 'zx', 's', 'sx', '', 'xsx', 'xyzx'];
const held = [0.05, 0.4, -0.1] as const;
const modes = (kind: string): DragMode[] => {
  const index = 4; // the first value of the dragged joint, after the ball of its parent
  const value = kind === '' || kind.startsWith('b') ? [] : [{ kind: 'value', index } as const];
  return [{ kind: 'follow' }, { kind: 'course' }, { kind: 'roll', farEnd: [0, 0.5, 0] }, ...value];
};

describe.each(allKinds)('dragging a joint of kind "%s"', (kind) => {
  it('gives the exact pose again when the pointer comes back, and writes nothing in place', () => {
    fc.assert(
      fc.property(seeds, fc.array(fc.tuple(pixel, pixel), { maxLength: 6 }), (seed, path) => {
        const rig = dragRig(kind, seed);
        const { start, view } = startOver(rig, held, seed + 1);
        const before = rig.q.slice();
        for (const mode of modes(kind)) {
          const drag = beginDrag({ ...start, mode });
          let present = rig.q;
          for (const [x, y] of path) present = drag.move(view.pointerAt(x, y), present);
          expect(drag.move(start.pointer, present)).toEqual(before);
          expect(rig.q).toEqual(before);
        }
      }),
      { numRuns: 30 },
    );
  });

  it('never exceeds a limit, and changes only the joint, and its slides only when they are dragged', () => {
    fc.assert(
      fc.property(seeds, limits, pixel, pixel, (seed, range, x, y) => {
        const rig = dragRig(kind, seed, range);
        const { skeleton } = rig;
        const { start, view } = startOver(rig, held, seed + 1);
        for (const mode of modes(kind)) {
          const q = beginDrag({ ...start, mode }).move(view.pointerAt(x, y));
          q.forEach((value, i) => {
            expect(value).toBeGreaterThanOrEqual(skeleton.qMin[i]!);
            expect(value).toBeLessThanOrEqual(skeleton.qMax[i]!);
          });
          expect(q.subarray(0, 4)).toEqual(rig.q.subarray(0, 4));
          if (kind.startsWith('s') && mode.kind !== 'value') {
            expect(q.subarray(4, 7)).toEqual(rig.q.subarray(4, 7));
          }
          if (mode.kind === 'value') {
            const others = q.map((value, i) => (i === mode.index ? 0 : value));
            expect(others).toEqual(rig.q.map((value, i) => (i === mode.index ? 0 : value)));
          }
        }
      }),
      { numRuns: 40 },
    );
  });

  it('gives a pose near the start for a pointer near the start', () => {
    fc.assert(
      fc.property(seeds, limits, (seed, range) => {
        const rig = dragRig(kind, seed, range);
        const { start, view } = startOver(rig, held, seed + 1);
        const { x, y } = start.pointer;
        for (const mode of modes(kind)) {
          const q = beginDrag({ ...start, mode }).move(view.pointerAt(x + 1e-6, y - 1e-6));
          const moved = transform(worldOf(rig, q), held);
          expect(largestDifference(moved, start.grabbed)).toBeLessThan(1e-3);
        }
      }),
      { numRuns: 40 },
    );
  });
});

describe.each(turningKinds)('a joint of kind "%s" that turns any way', (kind) => {
  it('keeps the grabbed point under the pointer within its reach', () => {
    let within = 0;
    fc.assert(
      fc.property(seeds, pixel, pixel, (seed, x, y) => {
        const rig = dragRig(kind, seed);
        const { start, view, pivot } = startOver(rig, held, seed + 1);
        const drag = beginDrag({ ...start, mode: { kind: 'follow' } });
        const q = drag.move(view.pointerAt(x, y));
        const grabbed = transform(worldOf(rig, q), held);
        expect(largestDifference(drag.grabbedAt(q), grabbed)).toBeLessThan(tolerances.turn);
        const [px, py] = view.pixelsOf(grabbed);
        const reach = Math.hypot(...held);
        // From the eye, the sphere of its reach covers angles below asin(reach / distance).
        const away = view.pointerAt(x, y).ray.direction;
        const toPivot = pivot.map((value, i) => value - view.eye[i]!);
        const along = toPivot.reduce((sum, value, i) => sum + value * away[i]!, 0);
        const beside = Math.sqrt(Math.max(0, Math.hypot(...toPivot) ** 2 - along ** 2));
        if (beside < reach * 0.999) {
          within++;
          expect(Math.hypot(px - x, py - y)).toBeLessThan(1);
          expect(Math.hypot(px - x, py - y)).toBeLessThan(1e-5);
        } else {
          // Out of reach, the point is on the line from the pivot to the pointer.
          const [cx, cy] = view.pixelsOf(pivot);
          const cosine =
            ((px - cx) * (x - cx) + (py - cy) * (y - cy)) /
            (Math.hypot(px - cx, py - cy) * Math.hypot(x - cx, y - cy));
          expect(cosine).toBeGreaterThan(1 - 1e-6);
        }
      }),
      { numRuns: 200 },
    );
    expect(within).toBeGreaterThan(5);
  });
});

describe('which joints turn', () => {
  it.each([
    ['b', true],
    ['x', true],
    ['sb', true],
    ['s', false],
    ['', false],
  ])('kind "%s": %s', (kind, expected) => {
    expect(canTurn(dragRig(kind, 1).skeleton, 1)).toBe(expected);
  });

  it('a locked hinge does not', () => {
    expect(canTurn(dragRig('xyz', 1, [0, 0]).skeleton, 1)).toBe(false);
  });
});
