import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { closedComponents } from '../../../src/evaluation/comparison/closed-components.ts';
import { enclosedVolume, surfaceArea } from '../../../src/evaluation/comparison/enclosed-volume.ts';
import { volumeRatio } from '../../../src/evaluation/comparison/volume.ts';
import { cube, meshOf, type Solid, sphere, together, torn } from '../../fixtures/solids.ts';
import { tolerances } from '../../tolerances.ts';

/** The volume ratio of a solid whose points are moved. */
function ratioOf(solid: Solid, move: (point: readonly number[], index: number) => number[]) {
  const mesh = meshOf(solid);
  const posed = Float32Array.from(solid.points.flatMap(move));
  return volumeRatio(mesh, mesh.positions, posed);
}

const doubled = (point: readonly number[]): number[] => point.map((value) => 2 * value);
const reversed = ({ points, triangles }: Solid): Solid => {
  return { points, triangles: triangles.map((corners) => corners.toReversed()) };
};
const withoutLid = ({ points, triangles }: Solid): Solid => {
  return { points, triangles: triangles.slice(1) };
};

describe('the volume that a surface encloses', () => {
  it('is that of exact solids, as is the area', () => {
    const box = meshOf(cube(2, [-3, 5, 1]));
    expect(enclosedVolume(box.positions, box.indices)).toBe(8);
    expect(surfaceArea(box.positions, box.indices)).toBe(24);
    // A polyhedron with corners on the unit sphere and 96 sides about its axis is a little smaller.
    const ball = meshOf(sphere());
    const volume = enclosedVolume(ball.positions, ball.indices);
    expect(Math.abs(volume / ((4 / 3) * Math.PI) - 1)).toBeLessThan(3e-3);
    expect(Math.abs(surfaceArea(ball.positions, ball.indices) / (4 * Math.PI) - 1)).toBeLessThan(
      3e-3,
    );
  });

  it('is not lost far from the origin', () => {
    const box = meshOf(cube(1, [4096, -8192, 4096]));
    expect(enclosedVolume(box.positions, box.indices)).toBe(1);
  });

  it('is multiplied by the determinant of an affine map', () => {
    const number = fc.double({ min: -2, max: 2, noNaN: true });
    const matrix = fc.array(number, { minLength: 9, maxLength: 9 });
    fc.assert(
      fc.property(matrix, fc.array(number, { minLength: 3, maxLength: 3 }), (m, move) => {
        const [a, b, c, d, e, f, g, h, i] = m;
        const determinant =
          a! * (e! * i! - f! * h!) - b! * (d! * i! - f! * g!) + c! * (d! * h! - e! * g!);
        const ratio = ratioOf(sphere(6, 9), ([x, y, z]) =>
          [0, 3, 6].map(
            (row, axis) => m[row]! * x! + m[row + 1]! * y! + m[row + 2]! * z! + move[axis]!,
          ),
        );
        expect(Math.abs(ratio! - determinant)).toBeLessThan(1e-4);
      }),
      { numRuns: 50 },
    );
  });
});

describe('the volume of a posed mesh against rest', () => {
  it('is 1 at rest and 8 at twice the size, whichever way the triangles face', () => {
    for (const solid of [cube(), torn(cube()), sphere(), reversed(cube())]) {
      expect(ratioOf(solid, (point) => [...point])).toBe(1);
      expect(ratioOf(solid, doubled)).toBeCloseTo(8, 5);
    }
  });

  it('is null for a surface with a hole, for a sheet and for nothing', () => {
    const sheet = { points: cube().points, triangles: [[0, 1, 2]] };
    const folded = together(sheet, reversed(sheet));
    for (const solid of [withoutLid(cube()), withoutLid(torn(cube())), sheet, folded]) {
      expect(ratioOf(solid, doubled)).toBeNull();
    }
    expect(ratioOf({ points: [], triangles: [] }, doubled)).toBeNull();
  });

  it('is null where a triangle of a closed surface faces the other way', () => {
    const { points, triangles } = cube();
    const [first, ...others] = triangles;
    expect(ratioOf({ points, triangles: [first!.toReversed(), ...others] }, doubled)).toBeNull();
  });

  it('counts the closed parts alone, and those of a hundredth of the area alone', () => {
    const open = together(cube(), withoutLid(cube(1, [3, 0, 0])));
    expect(closedComponents(meshOf(open))).toHaveLength(1);
    const [small, large] = [cube(0.1, [5, 0, 0]), cube(0.2, [5, 0, 0])];
    expect(closedComponents(meshOf(together(cube(), small)))).toHaveLength(1);
    expect(closedComponents(meshOf(together(cube(), large)))).toHaveLength(2);
    // Only the second cube grows.
    const two = together(cube(), cube(1, [3, 0, 0]));
    expect(ratioOf(two, (point, i) => (i < 8 ? [...point] : doubled(point)))).toBeCloseTo(4.5, 6);
  });

  it('keeps parts apart that only have a corner in common', () => {
    const touching = together(cube(), withoutLid(cube(1, [1, 1, 1])));
    expect(closedComponents(meshOf(touching))).toHaveLength(1);
  });

  it('stays closed where a seam opens', () => {
    // The copies of a corner are posed as the first of them, wherever they are themselves.
    const solid = torn(cube());
    const first = solid.points.map((point) =>
      solid.points.findIndex((other) => other.join() === point.join()),
    );
    const ratio = ratioOf(solid, (point, i) => (first[i] === i ? doubled(point) : [...point]));
    expect(Math.abs(ratio! - 8)).toBeLessThan(8 * tolerances.float32);
  });
});
