import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { beginDrag } from '../../src/posing/drag.ts';
import { coursePixelRate } from '../../src/posing/mouse-turns.ts';
import { multiply, rotationAbout, transform, unit } from '../reference/matrix.ts';
import { largestDifference } from '../support/compare.ts';
import { tolerances } from '../tolerances.ts';
import { dot, dragRig, startOver, type TestView, turningKinds, worldOf } from './drag-rigs.ts';

const seeds = fc.nat(1e6);
const motion = fc.double({ min: -200, max: 200, noNaN: true });
const held = [0.05, 0.4, -0.1] as const;

/** The oracle for the axis: the picture's up for motion to the right, its left for motion up. */
function axisOf({ up, right }: TestView, x: number, y: number): number[] {
  return unit([0, 1, 2].map((i) => up[i]! * x - right[i]! * y));
}

describe("the course program's drag", () => {
  it.each(turningKinds)('turns a joint "%s" about the axis across view and motion', (kind) => {
    fc.assert(
      fc.property(seeds, motion, motion, (seed, x, y) => {
        fc.pre(Math.hypot(x, y) > 1e-3);
        const rig = dragRig(kind, seed);
        const { start, view, world, pivot } = startOver(rig, held, seed + 1);
        const drag = beginDrag({ ...start, mode: { kind: 'course' } });
        const { pointer } = start;
        const q = drag.move(view.pointerAt(pointer.x + x, pointer.y + y));
        const angle = coursePixelRate * Math.hypot(x, y);
        const expected = multiply(rotationAbout(axisOf(view, x, y), angle), world);
        const turned = worldOf(rig, q);
        const columns = [0, 1, 2].map((row) => turned[row]!.slice(0, 3));
        expect(
          largestDifference(
            columns.flat(),
            [0, 1, 2].flatMap((row) => expected[row]!.slice(0, 3)),
          ),
        ).toBeLessThan(tolerances.turn);
        expect(largestDifference(transform(turned, [0, 0, 0]), pivot)).toBeLessThan(
          tolerances.turn,
        );
      }),
    );
  });

  it('moves points that face the viewer with the mouse', () => {
    const rig = dragRig('b', 5);
    const { start, view, pivot, world } = startOver(rig, held, 6);
    const toward = unit(view.eye.map((value, i) => value - pivot[i]!));
    // Converted to the joint's frame by the transpose of its rotation.
    const facing = [0, 1, 2].map(
      (c) =>
        0.3 *
        dot(
          world.map((row) => row[c]!),
          toward,
        ),
    );
    const drag = beginDrag({ ...start, mode: { kind: 'course' } });
    const q = drag.move(view.pointerAt(start.pointer.x + 20, start.pointer.y + 10));
    const [x, y] = view.pixelsOf(transform(worldOf(rig, q), facing));
    expect(x).toBeGreaterThan(5);
    expect(y / x).toBeCloseTo(0.5, 1);
  });

  it('turns a single hinge by its share', () => {
    fc.assert(
      fc.property(seeds, motion, motion, (seed, x, y) => {
        fc.pre(Math.hypot(x, y) > 1e-3);
        const rig = dragRig('x', seed);
        const { start, view, world } = startOver(rig, held, seed + 1);
        const drag = beginDrag({ ...start, mode: { kind: 'course' } });
        const q = drag.move(view.pointerAt(start.pointer.x + x, start.pointer.y + y));
        const angle = coursePixelRate * Math.hypot(x, y);
        const hinge = world.slice(0, 3).map((row) => row[0]!);
        const share = angle * dot(axisOf(view, x, y), hinge);
        expect(q.at(-1)! - rig.q.at(-1)!).toBeCloseTo(share, 9);
      }),
    );
  });

  it('applies to a point that is too near to the joint to follow the pointer', () => {
    const rig = dragRig('xyz', 5);
    const { start, view } = startOver(rig, [0.001, 0, 0], 6);
    const to = view.pointerAt(start.pointer.x + 3, start.pointer.y - 2);
    const course = beginDrag({ ...start, mode: { kind: 'course' } }).move(to);
    const follow = { ...start, mode: { kind: 'follow' }, leastReach: 0.01 } as const;
    expect(beginDrag(follow).move(to)).toEqual(course);
    const index = rig.q.length - 3; // the hinge about x; the point is on its axis
    const knob = { ...start, mode: { kind: 'value', index }, leastReach: 0.01 } as const;
    const change = beginDrag(knob).move(to)[index]! - rig.q[index]!;
    expect(Math.abs(change)).toBeLessThan(0.04);
    expect(Math.abs(change)).toBeGreaterThan(0);
  });
});
