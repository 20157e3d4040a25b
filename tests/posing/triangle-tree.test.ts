import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { emptyMesh, type Mesh } from '../../src/core/mesh.ts';
import type { Ray } from '../../src/core/ray.ts';
import { rayTriangle } from '../../src/core/ray-triangle.ts';
import { TriangleTree } from '../../src/posing/triangle-tree.ts';
import { randomBetween, randomSource } from '../support/random.ts';

/** The oracle: tests every triangle, in the order of the mesh. */
function nearestOfAll({ indices }: Mesh, positions: Float32Array, ray: Ray) {
  let best = { triangle: -1, distance: Infinity, second: 0, third: 0 };
  for (let triangle = 0; triangle < indices.length / 3; triangle++) {
    const corners = [...indices.subarray(triangle * 3, triangle * 3 + 3)].map((i) => i * 3);
    const met = { distance: 0, second: 0, third: 0 };
    const [a, b, c] = corners as [number, number, number];
    if (!rayTriangle(ray, positions, a, b, c, met) || met.distance >= best.distance) continue;
    best = { triangle, ...met };
  }
  return best.triangle === -1 ? null : best;
}

/** Small numbers, so that triangles often share corners, are coplanar, or have no area. */
const coordinate = fc.oneof(fc.integer({ min: -3, max: 3 }), fc.float({ min: -3, max: 3 }));
const point = fc.tuple(coordinate, coordinate, coordinate);
const places = fc.array(point, { minLength: 3, maxLength: 40 });
const ray = fc
  .tuple(point, point)
  .map(([origin, aim]) => ({ origin, away: aim.map((value, i) => value - origin[i]!) }))
  .filter(({ away }) => Math.hypot(...away) > 1e-3)
  .map(({ origin, away }): Ray => {
    const [x, y, z] = away.map((value) => value / Math.hypot(...away)) as [number, number, number];
    return { origin, direction: [x, y, z] };
  });

function meshOf(points: readonly (readonly number[])[], corners: readonly number[]): Mesh {
  const indices = Uint32Array.from(
    corners.slice(0, corners.length - (corners.length % 3)),
    (corner) => corner % points.length,
  );
  return { ...emptyMesh, positions: Float32Array.from(points.flat()), indices };
}

describe('a tree of triangles', () => {
  it('finds the same triangle as testing all of them, at rest and in poses', () => {
    const corners = fc.array(fc.nat(1000), { maxLength: 240 });
    fc.assert(
      fc.property(
        places,
        corners,
        fc.array(ray, { minLength: 4 }),
        fc.array(coordinate, { minLength: 1 }),
        (points, numbers, rays, moves) => {
          const mesh = meshOf(points, numbers);
          const tree = new TriangleTree(mesh);
          for (const each of rays) {
            expect(tree.nearest(each)).toEqual(nearestOfAll(mesh, mesh.positions, each));
          }
          const posed = mesh.positions.map((value, i) => value + moves[i % moves.length]!);
          tree.refit(posed);
          for (const each of rays) {
            expect(tree.nearest(each)).toEqual(nearestOfAll(mesh, posed, each));
          }
        },
      ),
    );
  });

  it('skips NaN coordinates', () => {
    const mesh = meshOf([[0, 0, 0], [1, 0, 0], [0, 1, 0], [NaN, NaN, 1]], [3, 0, 1, 0, 1, 2]); // prettier-ignore
    const hit = new TriangleTree(mesh).nearest({ origin: [0.2, 0.2, 5], direction: [0, 0, -1] });
    expect(hit).toMatchObject({ triangle: 1, distance: 5 });
  });

  it('tests only a small part of a large mesh', () => {
    const side = 120;
    const random = randomSource(3);
    const points = Array.from({ length: side * side }, (_, i) => {
      return [i % side, Math.floor(i / side), randomBetween(random, 0, 0.5)];
    });
    const corners = Array.from({ length: (side - 1) * (side - 1) }, (_, i) => {
      const at = i + Math.floor(i / (side - 1));
      return [at, at + 1, at + side, at + 1, at + side + 1, at + side];
    }).flat();
    const mesh = meshOf(points, corners);
    let reads = 0;
    const counted = new Proxy(mesh.indices, {
      get: (indices, key) => {
        reads++;
        return Reflect.get(indices, key) as unknown;
      },
    });
    const tree = new TriangleTree({ ...mesh, indices: counted });
    reads = 0;
    const hit = tree.nearest({ origin: [40.3, 70.6, 9], direction: [0, 0, -1] });
    expect(hit?.distance).toBeGreaterThan(8);
    expect(reads / 3).toBeLessThan(100);
    expect(corners.length / 3).toBeGreaterThan(28_000);
  });
});
