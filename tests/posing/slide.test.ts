import { vec3 } from 'gl-matrix';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { Ray } from '../../src/core/ray.ts';
import { slideOnLine, slideOnPlane } from '../../src/posing/slide.ts';

const number = (min: number, max: number) => fc.double({ min, max, noNaN: true });
const triple = fc.tuple(number(-2, 2), number(-2, 2), number(-2, 2));
const unit = triple
  .filter((vector) => vec3.length(vector) > 0.3)
  .map((vector) => vec3.normalize(new Float64Array(3), vector));

function rayTo(eye: vec3, point: vec3): Ray {
  const direction = vec3.subtract(new Float64Array(3), point, eye);
  return { origin: eye, direction: vec3.normalize(direction, direction) };
}

const eye: vec3 = [4, 3, 9];

describe('a handle slides with the pointer', () => {
  it('on its line, as far as the points of the line that the pointer is at', () => {
    fc.assert(
      fc.property(triple, unit, number(-1, 1), number(-1, 1), (origin, direction, a, b) => {
        const at = (part: number): vec3 =>
          vec3.scaleAndAdd(new Float64Array(3), origin, direction, part);
        const [from, to] = [rayTo(eye, at(a)), rayTo(eye, at(b))];
        const slid = slideOnLine(origin, direction, from, to);
        // A line that points at the eye can't be followed.
        const sine = vec3.length(vec3.cross([0, 0, 0], direction, from.direction));
        if (sine > 0.05) expect(slid).toBeCloseTo(b - a, 8);
        expect(slideOnLine(origin, direction, from, from) ?? 0).toBe(0);
      }),
    );
  });

  it('on its plane, from point to point', () => {
    fc.assert(
      fc.property(triple, unit, triple, triple, (origin, normal, a, b) => {
        const on = ([x, y, z]: readonly number[]): vec3 => {
          const point: vec3 = [x!, y!, z!];
          const across = vec3.dot(vec3.subtract([0, 0, 0], point, origin), normal);
          return vec3.scaleAndAdd(new Float64Array(3), point, normal, -across);
        };
        const [start, end] = [on(a), on(b)];
        const [from, to] = [rayTo(eye, start), rayTo(eye, end)];
        const slopes = [from, to].map((ray) => Math.abs(vec3.dot(ray.direction, normal)));
        fc.pre(Math.min(...slopes) > 0.05);
        const slid = slideOnPlane(origin, normal, from, to)!;
        Array.from(slid as Float64Array).forEach((value, i) =>
          expect(value).toBeCloseTo(end[i]! - start[i]!, 8),
        );
      }),
    );
  });

  it('nowhere if the ray runs beside it, or meets it only behind the eye', () => {
    const level: Ray = { origin: [0, 1, 5], direction: [0, 0, -1] };
    const down: Ray = { origin: [0, 1, 5], direction: [0, -0.6, -0.8] };
    const up: Ray = { origin: [0, 1, 5], direction: [0, 0.6, -0.8] };
    expect(slideOnPlane([0, 0, 0], [0, 1, 0], down, level)).toBeNull();
    expect(slideOnPlane([0, 0, 0], [0, 1, 0], down, up)).toBeNull();
    expect(slideOnPlane([0, 0, 0], [0, 1, 0], down, down)).toEqual(Float64Array.of(0, 0, 0));
    expect(slideOnLine([0, 0, 0], [0, 0, 1], down, level)).toBeNull();
    expect(slideOnLine([0, 0, 9], [1, 0, 0], down, down)).toBeNull();
    expect(slideOnLine([0, 0, 0], [1, 0, 0], down, down)).toBe(0);
  });
});
