import earcut from 'earcut';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { triangulate } from '../../../src/formats/obj/triangulate.ts';
import { tolerances } from '../../tolerances.ts';
import { multiply, rotationAbout, transform, unit } from '../../reference/matrix.ts';

type Polygon = readonly (readonly number[])[];

function cut(polygon: Polygon): number[] {
  const corners = polygon.map((_, index) => index);
  return triangulate(polygon.flat(), corners, earcut);
}

/** Twice the signed area of each triangle, seen from +z. */
function areas(polygon: Polygon, triangles: readonly number[]): number[] {
  return Array.from({ length: triangles.length / 3 }, (_, index) => {
    const [a, b, c] = [0, 1, 2].map((i) => polygon[triangles[index * 3 + i]!]!);
    return (b![0]! - a![0]!) * (c![1]! - a![1]!) - (b![1]! - a![1]!) * (c![0]! - a![0]!);
  });
}

function outlineArea(polygon: Polygon): number {
  return polygon.reduce((sum, [x, y], index) => {
    const next = polygon[(index + 1) % polygon.length]!;
    return sum + x! * next[1]! - y! * next[0]!;
  }, 0);
}

/**
 * All corners are used and no triangle is outside or reversed, so the parts cover exactly the
 * polygon.
 */
function expectExact(polygon: Polygon, triangles = cut(polygon)): void {
  const parts = areas(polygon, triangles);
  const whole = outlineArea(polygon);
  expect(triangles).toHaveLength((polygon.length - 2) * 3);
  expect(new Set(triangles).size).toBe(polygon.length);
  for (const part of parts) expect(part * Math.sign(whole)).toBeGreaterThanOrEqual(-1e-9);
  const sum = parts.reduce((total, part) => total + part, 0);
  expect(Math.abs(sum - whole)).toBeLessThan(tolerances.float32 * Math.abs(whole));
}

function regular(count: number): Polygon {
  return Array.from({ length: count }, (_, index) => {
    const angle = (2 * Math.PI * index) / count;
    return [Math.cos(angle), Math.sin(angle), 0];
  });
}

const arrow: Polygon = [
  [0, 0, 0],
  [2, -1, 0],
  [0.5, 0, 0],
  [2, 1, 0],
];
const ell: Polygon = [
  [0, 0, 0],
  [2, 0, 0],
  [2, 1, 0],
  [1, 1, 0],
  [1, 2, 0],
  [0, 2, 0],
];
/** The same with corners in the middle of straight edges, as in meshes with T-junctions. */
const ellWithMiddles: Polygon = ell.flatMap((corner, index) => {
  const next = ell[(index + 1) % ell.length]!;
  return [corner, corner.map((value, axis) => (value + next[axis]!) / 2)];
});

describe('triangulate', () => {
  it('cuts a convex polygon as a fan about its first corner', () => {
    expect(cut(regular(3))).toEqual([0, 1, 2]);
    expect(cut(regular(5))).toEqual([0, 1, 2, 0, 2, 3, 0, 3, 4]);
    expectExact(regular(12));
  });

  it.each([
    ['an arrow', arrow],
    ['an L', ell],
    ['an L with corners on its straight edges', ellWithMiddles],
  ])('cuts %s from any corner on, either way round and in any plane', (_, polygon) => {
    const turn = multiply(rotationAbout(unit([1, 2, 3]), 2.5), rotationAbout([1, 0, 0], 1));
    polygon.forEach((_, first) => {
      const rolled = [...polygon.slice(first), ...polygon.slice(0, first)];
      expectExact(rolled);
      expectExact(rolled.toReversed());
      const turned = rolled.map((point) => transform(turn, point));
      expectExact(rolled, cut(turned));
    });
  });

  it('cuts any star-shaped polygon exactly', () => {
    const radii = fc.array(fc.double({ min: 0.2, max: 1, noNaN: true }), {
      minLength: 4,
      maxLength: 30,
    });
    fc.assert(
      fc.property(radii, (lengths) => {
        expectExact(
          regular(lengths.length).map((point, i) => point.map((value) => value * lengths[i]!)),
        );
      }),
    );
  });

  it('gives the full number of triangles for polygons that have no proper area', () => {
    const corners = fc.array(fc.tuple(fc.nat(2), fc.nat(2), fc.nat(2)), {
      minLength: 3,
      maxLength: 12,
    });
    fc.assert(
      fc.property(corners, (polygon) => {
        const triangles = cut(polygon);
        expect(triangles).toHaveLength((polygon.length - 2) * 3);
        expect(triangles.every((corner) => corner < polygon.length)).toBe(true);
      }),
    );
  });
});
