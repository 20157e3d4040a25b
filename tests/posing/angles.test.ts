import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { beginDrag } from '../../src/posing/drag.ts';
import { transform } from '../reference/matrix.ts';
import { randomBetween, randomSource } from '../support/random.ts';
import { dot, dragRig, startOver, worldOf } from './drag-rigs.ts';

const seeds = fc.nat(1e6);
const pixel = fc.double({ min: -300, max: 300, noNaN: true });
const turn = 2 * Math.PI;
const held = [0.3, 0.4, -0.1] as const;

/** All triples of the same rotation near given angles: by the identity, and by full turns. */
function equivalents([a, b, c]: readonly number[]): number[][] {
  const turns = [-2, -1, 0, 1, 2].map((k) => k * turn);
  return [
    [a!, b!, c!],
    [a! + Math.PI, Math.PI - b!, c! + Math.PI],
  ].flatMap(([x, y, z]) =>
    turns.flatMap((i) => turns.flatMap((j) => turns.map((k) => [x! + i, y! + j, z! + k]))),
  );
}

function distance(a: readonly number[], b: readonly number[]): number {
  return a.reduce((sum, value, i) => sum + Math.abs(value - b[i]!), 0);
}

describe.each(['xyz', 'zyx', 'sxyz', 'zxy', 'yzx'])('angles of a dragged joint "%s"', (kind) => {
  it('are the nearest of the equivalent triples to the present ones', () => {
    fc.assert(
      fc.property(seeds, pixel, pixel, (seed, x, y) => {
        const rig = dragRig(kind, seed);
        const { start, view } = startOver(rig, held, seed + 1);
        const drag = beginDrag({ ...start, mode: { kind: 'follow' } });
        const present = rig.q.slice();
        const from = present.length - 3;
        for (let i = from; i < present.length; i++) present[i]! += ((seed % 7) - 3) * 1.3;
        const triple = [...drag.move(view.pointerAt(x, y), present).subarray(from)];
        const near = [...present.subarray(from)];
        const least = Math.min(...equivalents(triple).map((each) => distance(each, near)));
        expect(distance(triple, near)).toBeLessThanOrEqual(least + 1e-9);
      }),
    );
  });

  it('do not jump along a smooth path away from gimbal lock', () => {
    let steps = 0;
    fc.assert(
      fc.property(seeds, pixel, pixel, (seed, x, y) => {
        const rig = dragRig(kind, seed);
        const { start, view } = startOver(rig, held, seed + 1);
        const drag = beginDrag({ ...start, mode: { kind: 'follow' } });
        const from = rig.q.length - 3;
        const at = (part: number) =>
          view.pointerAt(
            start.pointer.x + part * (x - start.pointer.x),
            start.pointer.y + part * (y - start.pointer.y),
          );
        const count = 400;
        let present = rig.q;
        let before = worldOf(rig, rig.q);
        for (let i = 1; i <= count; i++) {
          const next = drag.move(at(i / count), present);
          const world = worldOf(rig, next);
          const turned = angleBetween(before, world);
          const slack = Math.abs(Math.cos(next[from + 1]!));
          // Near gimbal lock, angles change like the rotation divided by the cosine of the middle
          // angle.
          if (slack > 0.2 && turned < 0.05) {
            steps++;
            const jump = Math.max(
              ...[0, 1, 2].map((k) => Math.abs(next[from + k]! - present[from + k]!)),
            );
            expect(jump).toBeLessThan((3 * turned) / (slack - 0.1) + 1e-7);
          }
          [present, before] = [next, world];
        }
      }),
      { numRuns: 10 },
    );
    expect(steps).toBeGreaterThan(500);
  });

  it('continue through gimbal lock and keep the point under the pointer', () => {
    const rig = dragRig(kind, 3);
    const from = rig.q.length - 3;
    const q = rig.q.slice();
    q[from + 1] = Math.PI / 2;
    const posed = { ...rig, q };
    const { start, view } = startOver(posed, held, 9);
    const drag = beginDrag({ ...start, mode: { kind: 'follow' } });
    for (const step of [1e-7, 1e-3, 1, 20]) {
      const { x, y } = start.pointer;
      const next = drag.move(view.pointerAt(x + step, y - step / 2));
      const [px, py] = view.pixelsOf(transform(worldOf(posed, next), held));
      expect(Math.hypot(px - x - step, py - y + step / 2)).toBeLessThan(0.01);
    }
  });
});

function angleBetween(
  a: readonly (readonly number[])[],
  b: readonly (readonly number[])[],
): number {
  const skew = [0, 1, 2].reduce(
    (sum, c) => sum + [0, 1, 2].reduce((all, r) => all + (a[r]![c]! - b[r]![c]!) ** 2, 0),
    0,
  );
  return 2 * Math.asin(Math.min(1, Math.sqrt(skew / 8)));
}

describe('the value of one degree of freedom', () => {
  /** The oracle: the ray's distance from the grabbed point, for every value on a grid. */
  function bestOnGrid(kind: string, seed: number, x: number, y: number, range: [number, number]) {
    const rig = dragRig(kind, seed, range);
    const { start, view } = startOver(rig, held, seed + 1);
    const index = rig.q.length - 1;
    const { ray } = view.pointerAt(x, y);
    const gap = (value: number): number => {
      const q = rig.q.slice();
      q[index] = value;
      const place = transform(worldOf(rig, q), held).map((v, i) => v - ray.origin[i]!);
      const along = dot(place, ray.direction);
      return Math.sqrt(Math.max(0, dot(place, place) - along * along));
    };
    const [low, high] = [rig.skeleton.qMin[index]!, rig.skeleton.qMax[index]!];
    const grid = Array.from({ length: 161 }, (_, i) => low + ((high - low) * i) / 160);
    const found = beginDrag({ ...start, mode: { kind: 'value', index } }).move(
      view.pointerAt(x, y),
    )[index]!;
    return { least: Math.min(...grid.map(gap)), found: gap(found), value: found, low, high, gap };
  }

  it.each(['x', 'xyz', 'zyx', 'sz'])('of a hinge is the one nearest to the ray: "%s"', (kind) => {
    fc.assert(
      fc.property(seeds, pixel, pixel, (seed, x, y) => {
        const best = bestOnGrid(kind, seed, x, y, [-1.2, 0.7]);
        // Except for the small preference for the start, which decides between front and back.
        const radius = Math.hypot(...held);
        expect(best.found ** 2).toBeLessThan(best.least ** 2 + 0.02 * radius ** 2 + 1e-9);
        // There, the distance has a minimum, or a limit is reached.
        if (best.value > best.low + 1e-4 && best.value < best.high - 1e-4) {
          expect(best.gap(best.value + 1e-4)).toBeGreaterThan(best.found - 1e-9);
          expect(best.gap(best.value - 1e-4)).toBeGreaterThan(best.found - 1e-9);
        }
      }),
      { numRuns: 40 },
    );
  });

  it('of a slide is the one nearest to the ray', () => {
    fc.assert(
      fc.property(seeds, pixel, pixel, (seed, x, y) => {
        const rig = dragRig('s', seed);
        const { start, view } = startOver(rig, held, seed + 1);
        const index = rig.q.length - 2;
        const q = beginDrag({ ...start, mode: { kind: 'value', index } }).move(
          view.pointerAt(x, y),
        );
        const { ray } = view.pointerAt(x, y);
        const gap = (value: number): number => {
          const other = q.slice();
          other[index] = value;
          const place = transform(worldOf(rig, other), held).map((v, i) => v - ray.origin[i]!);
          return dot(place, place) - dot(place, ray.direction) ** 2;
        };
        expect(gap(q[index]! + 1e-3)).toBeGreaterThanOrEqual(gap(q[index]!) - 1e-9);
        expect(gap(q[index]! - 1e-3)).toBeGreaterThanOrEqual(gap(q[index]!) - 1e-9);
      }),
    );
  });

  it('goes on past π when the pointer goes around', () => {
    const rig = dragRig('z', 12);
    const { start, view } = startOver(rig, [0.4, 0, 0], 1);
    const index = rig.q.length - 1;
    const drag = beginDrag({ ...start, mode: { kind: 'value', index } });
    const world = worldOf(rig, rig.q);
    let present = rig.q;
    const angle = (k: number) => (k / 60) * 1.9 * Math.PI;
    for (let k = 1; k <= 60; k++) {
      const [c, s] = [Math.cos(angle(k)), Math.sin(angle(k))];
      const over = transform(world, [0.4 * c, 0.4 * s, 0]);
      present = drag.move(view.pointerOver(over), present);
      expect(present[index]! - rig.q[index]!).toBeCloseTo(angle(k), 6);
    }
  });
});

describe('hinges that cannot take every rotation', () => {
  it.each([
    ['two hinges', 'xy'],
    ['three with limits', 'xyz'],
  ])('come as near as their limits let them: %s', (_, kind) => {
    const random = randomSource(14);
    let near = 0;
    const count = 60;
    for (let i = 0; i < count; i++) {
      const rig = dragRig(kind, 100 + i, [-0.8, 0.6]);
      const { start, view, pivot } = startOver(rig, held, 200 + i);
      const to = view.pointerAt(randomBetween(random, -300, 300), randomBetween(random, -300, 300));
      const q = beginDrag({ ...start, mode: { kind: 'follow' } }).move(to);
      const arm = start.grabbed.map((v, axis) => v - pivot[axis]!);
      const side = dot(arm, start.pointer.ray.direction) > 0 ? 1 : -1;
      const target = sphereTarget(to.ray, pivot, start.grabbed, side);
      const miss = (values: Float64Array): number =>
        Math.hypot(...transform(worldOf(rig, values), held).map((v, axis) => v - target[axis]!));
      const best = bestInBox(rig.q.length, kind.length, rig.skeleton, rig.q, miss);
      if (miss(q) <= best + 0.03) near++;
      // From the result, no small step within the limits comes nearer.
      for (let step = q.length - kind.length; step < q.length; step++) {
        for (const change of [-1e-4, 1e-4]) {
          const other = q.slice();
          other[step]! += change;
          const { qMin, qMax } = rig.skeleton;
          if (other[step]! < qMin[step]! || other[step]! > qMax[step]!) continue;
          expect(miss(other)).toBeGreaterThan(miss(q) - 1e-7);
        }
      }
    }
    // The other starts are far out of reach and stay in the local minimum of the start: elsewhere
    // is a jump away.
    expect(near / count).toBeGreaterThan(0.8);
  });
});

/** The oracle: the position on the sphere of the grabbed point that the pointer demands. */
function sphereTarget(
  ray: { readonly origin: ArrayLike<number>; readonly direction: ArrayLike<number> },
  pivot: readonly number[],
  grabbed: readonly number[],
  side: 1 | -1,
): number[] {
  const arm = grabbed.map((v, i) => v - pivot[i]!);
  const radius = Math.hypot(...arm);
  const middle = pivot.reduce((sum, v, i) => sum + (v - ray.origin[i]!) * ray.direction[i]!, 0);
  const beside = pivot.map((v, i) => ray.origin[i]! + middle * ray.direction[i]! - v);
  const gap = Math.hypot(...beside);
  // By Pythagoras: along the ray from its point next to the pivot, or straight out to the
  // silhouette.
  const deep = side * Math.sqrt(Math.max(0, radius * radius - gap * gap));
  const out = Math.min(1, radius / gap);
  return pivot.map((v, i) => v + beside[i]! * out + deep * ray.direction[i]!);
}

/** The least distance over a grid of the last `hinges` values within their limits. */
function bestInBox(
  size: number,
  hinges: number,
  { qMin, qMax }: { readonly qMin: Float64Array; readonly qMax: Float64Array },
  q: Float64Array,
  miss: (values: Float64Array) => number,
): number {
  const steps = 8;
  let best = Infinity;
  const values = q.slice();
  const visit = (index: number): void => {
    if (index === size) {
      best = Math.min(best, miss(values));
      return;
    }
    for (let k = 0; k <= steps; k++) {
      values[index] = qMin[index]! + ((qMax[index]! - qMin[index]!) * k) / steps;
      visit(index + 1);
    }
  };
  visit(size - hinges);
  return best;
}
