import { describe, expect, it } from 'vitest';
import { computeVertexNormals } from '../../src/core/vertex-normals.ts';
import { unit } from '../reference/matrix.ts';
import { largestDifference } from '../support/compare.ts';
import { tolerances } from '../tolerances.ts';

function normalsOf(points: readonly (readonly number[])[], triangles: readonly number[]): number[] {
  const normals = new Float32Array(points.length * 3);
  computeVertexNormals(Float32Array.from(points.flat()), Uint32Array.from(triangles), normals);
  return [...normals];
}

const cube = [
  [-1, -1, -1],
  [1, -1, -1],
  [1, 1, -1],
  [-1, 1, -1],
  [-1, -1, 1],
  [1, -1, 1],
  [1, 1, 1],
  [-1, 1, 1],
];
const quads = [
  [4, 5, 6, 7],
  [1, 0, 3, 2],
  [5, 1, 2, 6],
  [0, 4, 7, 3],
  [7, 6, 2, 3],
  [0, 1, 5, 4],
];

describe('computeVertexNormals', () => {
  it.each([
    ['one way', [0, 1, 2, 0, 2, 3]],
    ['the other way', [1, 2, 3, 1, 3, 0]],
  ])("of a cube are its diagonals, with the faces' diagonals cut %s", (_, cut) => {
    const triangles = quads.flatMap((quad) => cut.map((corner) => quad[corner]!));
    const normals = normalsOf(cube, triangles);
    expect(largestDifference(normals, cube.flatMap(unit))).toBeLessThan(tolerances.float32);
  });

  it('of an octahedron point outwards; of one turned inside out, inwards', () => {
    const points = [
      [1, 0, 0],
      [-1, 0, 0],
      [0, 1, 0],
      [0, -1, 0],
      [0, 0, 1],
      [0, 0, -1],
    ];
    const triangles = [0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5];
    const outwards = normalsOf(points, triangles);
    expect(largestDifference(outwards, points.flat())).toBeLessThan(tolerances.float32);
    const inwards = normalsOf(points, triangles.toReversed());
    const opposite = points.flat().map((value) => -value);
    expect(largestDifference(inwards, opposite)).toBeLessThan(tolerances.float32);
  });

  it('weigh a face by its angle, not by its area', () => {
    const points = [
      [0, 0, 0],
      [100, 0, 0],
      [0, 100, 0],
      [0, 0, 1],
      [1, 0, 0],
    ];
    // A large face that faces +z and a small one that faces −y meet at the first point, both at
    // 90°.
    const [x, y, z] = normalsOf(points, [0, 1, 2, 0, 4, 3]);
    expect(largestDifference([x!, y!, z!], unit([0, -1, 1]))).toBeLessThan(tolerances.float32);
  });

  it('are +y where there is no face or only degenerate ones', () => {
    const line = [
      [0, 0, 0],
      [1, 1, 1],
      [2, 2, 2],
      [5, 5, 5],
    ];
    expect(normalsOf(line, [0, 1, 2, 0, 0, 1])).toEqual([0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0]);
  });

  it('are finite for the smallest and the largest coordinates', () => {
    for (const size of [1e-40, 1e-19, 1e19, 3e38]) {
      const points = cube.map((point) => point.map((value) => value * size));
      const normals = normalsOf(
        points,
        quads.flatMap(([a, b, c, d]) => [a!, b!, c!, a!, c!, d!]),
      );
      for (let i = 0; i < normals.length; i += 3) {
        expect(Math.hypot(...normals.slice(i, i + 3))).toBeCloseTo(1, 5);
      }
    }
  });
});
