import { mat4 } from 'gl-matrix';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  distanceOfClosest,
  pointOnRay,
  rayCapsule,
  rayCylinder,
  rayInFrame,
  raySphere,
} from '../../src/core/ray.ts';
import { randomBetween, randomSource, randomUnitVector } from '../support/random.ts';

type Triple = [number, number, number];

/** The oracle: the distance of a point from a segment, by definition. */
function distanceToSegment(point: ArrayLike<number>, from: Triple, to: Triple): number {
  const axis = [0, 1, 2].map((i) => to[i]! - from[i]!);
  const offset = [0, 1, 2].map((i) => point[i]! - from[i]!);
  const square = axis.reduce((sum, a) => sum + a * a, 0);
  const part = axis.reduce((sum, a, i) => sum + a * offset[i]!, 0) / (square || 1);
  const kept = Math.min(1, Math.max(0, part));
  return Math.hypot(...offset.map((value, i) => value - kept * axis[i]!));
}

/** Marches along the ray by the distance to the capsule until it is hit (Hart 1996). */
function march(origin: Triple, direction: Triple, from: Triple, to: Triple, radius: number) {
  let t = 0;
  for (let step = 0; step < 3000 && t < 50; step++) {
    const gap = distanceToSegment(pointOnRay({ origin, direction }, t), from, to) - radius;
    if (gap < 1e-10) return t;
    t += gap;
  }
  return Infinity;
}

describe('a ray', () => {
  it('hits a capsule at the same distance as marching along the ray', () => {
    const random = randomSource(5);
    const place = (size: number): Triple => {
      const [x, y, z] = [0, 1, 2].map(() => randomBetween(random, -size, size));
      return [x!, y!, z!];
    };
    let hits = 0;
    for (let i = 0; i < 1500; i++) {
      const [origin, from, to] = [place(3), place(1), i % 10 === 0 ? null : place(1)];
      const end = to ?? from; // a sphere
      const radius = randomBetween(random, 0.05, 0.6);
      if (distanceToSegment(origin, from, end) <= radius) continue;
      const aim = place(1);
      const away = aim.map((value, axis) => value - origin[axis]!);
      const length = Math.hypot(...away);
      const direction = away.map((value) => value / length) as Triple;
      const expected = march(origin, direction, from, end, radius);
      const found = rayCapsule({ origin, direction }, from, end, radius);
      // A ray that barely touches may count as a hit or a miss.
      const gap = distanceToSegment(
        pointOnRay({ origin, direction }, distanceOfClosest({ origin, direction }, from, end)),
        from,
        end,
      );
      if (Math.abs(gap - radius) < 1e-6) continue;
      if (expected === Infinity) expect(found).toBe(Infinity);
      else expect(Math.abs(found - expected)).toBeLessThan(1e-4);
      if (expected < Infinity) hits++;
    }
    expect(hits).toBeGreaterThan(250);
  });

  it('misses the side of a cylinder when parallel to it, and hits the capsule', () => {
    const ray = { origin: [0, 0, 5], direction: [0, 0, -1] } as const;
    expect(rayCylinder(ray, [0, 0, 0], [0, 0, 1], 0.5)).toBe(Infinity);
    expect(rayCapsule(ray, [0, 0, 0], [0, 0, 1], 0.5)).toBe(3.5);
  });

  it('does not hit what is behind it, and hits what is around it from within', () => {
    const ray = { origin: [0, 0, 5], direction: [0, 0, 1] } as const;
    expect(rayCapsule(ray, [-1, 0, 0], [1, 0, 0], 0.5)).toBe(Infinity);
    expect(raySphere(ray, [0, 0, 4.5], 1)).toBe(0.5);
  });

  it('is closest to a segment where no other point of it is closer', () => {
    const random = randomSource(6);
    for (let i = 0; i < 300; i++) {
      const [origin, direction] = [randomUnitVector(random), randomUnitVector(random)];
      const [from, to] = [randomUnitVector(random), randomUnitVector(random)];
      const ray = { origin: origin as Triple, direction: direction as Triple };
      const gapAt = (t: number) =>
        distanceToSegment(pointOnRay(ray, t), from as Triple, to as Triple);
      const found = distanceOfClosest(ray, from, to);
      expect(found).toBeGreaterThanOrEqual(0);
      const least = Math.min(...Array.from({ length: 400 }, (_, k) => gapAt(k / 100)));
      expect(gapAt(found)).toBeLessThanOrEqual(least + 1e-9);
    }
  });

  it('keeps its points in another frame', () => {
    const number = fc.double({ min: -3, max: 3, noNaN: true });
    fc.assert(
      fc.property(number, number, number, (angle, x, t) => {
        const frame = mat4.fromTranslation(new Float64Array(16), [x, 1, -2]);
        mat4.rotate(frame, frame, angle, [0.6, 0, 0.8]);
        mat4.scale(frame, frame, [2, 2, 2]);
        const ray = { origin: [1, 2, x], direction: [0, 0.6, -0.8] } as const;
        const there = rayInFrame(ray, frame);
        const [a, b] = [pointOnRay(ray, t), pointOnRay(there, t / 2)];
        const back = [0, 1, 2].map(
          (row) =>
            frame[row]! * b[0] + frame[4 + row]! * b[1] + frame[8 + row]! * b[2] + frame[12 + row]!,
        );
        back.forEach((value, i) => expect(value).toBeCloseTo(a[i]!, 9));
      }),
    );
  });
});
