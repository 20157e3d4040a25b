import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { beginDrag } from '../../src/posing/drag.ts';
import { rollJoint } from '../../src/posing/roll-joint.ts';
import { multiply, rotationAbout, transform, unit } from '../reference/matrix.ts';
import { largestDifference } from '../support/compare.ts';
import { tolerances } from '../tolerances.ts';
import { dragRig, startOver, turningKinds, worldOf } from './drag-rigs.ts';

const seeds = fc.nat(1e6);
const angles = fc.double({ min: -3, max: 3, noNaN: true });
const limits = fc.tuple(
  fc.double({ min: -1, max: 0, noNaN: true }),
  fc.double({ min: 0, max: 1, noNaN: true }),
);
const farEnd = [0.1, 0.6, -0.2] as const;

describe.each(turningKinds)('rolling a joint of kind "%s"', (kind) => {
  it('turns it about its bone as the oracle does, and keeps the far end', () => {
    fc.assert(
      fc.property(seeds, angles, (seed, angle) => {
        const rig = dragRig(kind, seed);
        const before = worldOf(rig, rig.q);
        const rolled = worldOf(rig, rollJoint(rig.skeleton, rig.q, 1, farEnd, angle));
        const expected = multiply(before, rotationAbout(unit(farEnd), angle));
        expect(largestDifference(rolled.flat(), expected.flat())).toBeLessThan(tolerances.turn);
        expect(
          largestDifference(transform(rolled, farEnd), transform(before, farEnd)),
        ).toBeLessThan(tolerances.turn);
      }),
    );
  });

  it('ends at a limit, and keeps the far end there too', () => {
    fc.assert(
      fc.property(seeds, limits, angles, (seed, range, angle) => {
        const rig = dragRig(kind, seed, range);
        const q = rollJoint(rig.skeleton, rig.q, 1, farEnd, angle);
        q.forEach((value, i) => {
          expect(value).toBeGreaterThanOrEqual(rig.skeleton.qMin[i]!);
          expect(value).toBeLessThanOrEqual(rig.skeleton.qMax[i]!);
        });
        const [now, before] = [worldOf(rig, q), worldOf(rig, rig.q)];
        expect(largestDifference(transform(now, farEnd), transform(before, farEnd))).toBeLessThan(
          tolerances.turn,
        );
      }),
    );
  });

  it('and rolling back restores the rotation', () => {
    fc.assert(
      fc.property(seeds, angles, (seed, angle) => {
        const rig = dragRig(kind, seed);
        const there = rollJoint(rig.skeleton, rig.q, 1, farEnd, angle);
        const back = rollJoint(rig.skeleton, there, 1, farEnd, -angle);
        expect(
          largestDifference(worldOf(rig, back).flat(), worldOf(rig, rig.q).flat()),
        ).toBeLessThan(tolerances.turn);
      }),
    );
  });

  it('by a drag is half a degree per pixel across the bone', () => {
    fc.assert(
      fc.property(seeds, (seed) => {
        const rig = dragRig(kind, seed);
        const { start, view, pivot, world } = startOver(rig, farEnd, seed + 1);
        const drag = beginDrag({ ...start, mode: { kind: 'roll', farEnd } });
        const [x, y] = [start.pointer.x, start.pointer.y];
        const [cx, cy] = view.pixelsOf(pivot);
        const length = Math.hypot(x - cx, y - cy);
        if (length < 60) return;
        // Ten pixels to the left of the bone in the picture, seen along it.
        const q = drag.move(
          view.pointerAt(x - ((y - cy) / length) * 10, y + ((x - cx) / length) * 10),
        );
        const expected = rollJoint(rig.skeleton, rig.q, 1, farEnd, 0);
        expect(expected).toEqual(rig.q);
        const turned = worldOf(rig, q);
        // The rotation about the axis, from the trace of the rotation between the two.
        const trace = [0, 1, 2].reduce(
          (sum, c) => sum + [0, 1, 2].reduce((all, r) => all + world[r]![c]! * turned[r]![c]!, 0),
          0,
        );
        const turn = (Math.acos(Math.min(1, (trace - 1) / 2)) * 180) / Math.PI;
        // With perspective, the bone in the picture differs slightly from its axis seen from far
        // away.
        expect(turn).toBeGreaterThan(3.5);
        expect(turn).toBeLessThan(5 + 1e-6);
        expect(largestDifference(transform(turned, farEnd), start.grabbed)).toBeLessThan(1e-9);
      }),
    );
  });
});

describe('a single hinge', () => {
  it('rolls within its limits if it is parallel to the bone, and otherwise does not move', () => {
    const rig = dragRig('y', 4, [-0.5, 0.25]);
    const at = rig.q.length - 1;
    const roll = (end: readonly [number, number, number], angle: number) =>
      rollJoint(rig.skeleton, rig.q, 1, end, angle)[at]! - rig.q[at]!;
    expect(roll([0, 2, 0], 0.1)).toBeCloseTo(0.1, 12);
    expect(roll([0, -2, 0], 0.1)).toBeCloseTo(-0.1, 12);
    expect(roll([0, 2, 0], 3)).toBeCloseTo(0.25, 12);
    expect(roll([0, 2, 0.1], 0.1)).toBe(0);
    expect(roll([0, 0, 0], 0.1)).toBe(0);
  });
});
