import { describe, expect, it } from 'vitest';
import { jointMatrices } from '../../src/core/forward-kinematics.ts';
import { volumeRatio } from '../../src/evaluation/comparison/volume.ts';
import { hasCenter, restCenters } from '../../src/skinning/rest-centers/rest-centers.ts';
import { twistingTube } from '../fixtures/twisting-tube.ts';
import { rotationCenters, turnedAboutCenter } from '../reference/centers-of-rotation.ts';
import type { Influence, Transforms } from '../reference/skinned-vertex.ts';
import { largestDifference, numbersAt } from '../support/compare.ts';
import { loadedKernel } from '../support/kernels.ts';
import { skinVertices } from '../support/skin-vertices.ts';
import { tolerances } from '../tolerances.ts';

const radius = 0.25;
const character = await twistingTube();
const { mesh, skin, skeleton } = character;
const method = loadedKernel('centers-of-rotation');
const quiet = (): void => undefined;

const points = Array.from({ length: mesh.pointCount }, (_, point) =>
  numbersAt(mesh.positions, point, 3),
);
const rows = points.map((_, point): readonly Influence[] => {
  const range = [skin.start[point]!, skin.start[point + 1]!] as const;
  return [...skin.entries.subarray(...range)].map((entry, i) => [
    entry,
    skin.weights[range[0] + i]!,
  ]);
});
const triangles = Array.from({ length: mesh.indices.length / 3 }, (_, triangle) => [
  ...mesh.indices.subarray(triangle * 3, triangle * 3 + 3),
]);
const expected = rotationCenters(points, triangles, rows);
const degrees = Math.PI / 180;

/** The tube with its last joint turned about x (a bend) or y (a twist). */
function posed(axis: 'x' | 'y', angle: number) {
  const q = skeleton.qRest.slice();
  q[q.length - (axis === 'x' ? 3 : 2)] = angle * degrees;
  return { positions: skinVertices(character, skin, { q }, method).positions, q };
}

/** A 4 × 4 matrix as rows. */
function matrixAt(values: Float64Array, index: number): number[][] {
  return [0, 1, 2, 3].map((row) =>
    [0, 1, 2, 3].map((column) => values[index * 16 + column * 4 + row]!),
  );
}

describe('the centers of a tube', () => {
  it('are those of the exact sum, and none where a point follows one joint', () => {
    const centers = restCenters(mesh, skin, quiet);
    let count = 0;
    expected.forEach((center, point) => {
      expect(hasCenter(centers, point * 3)).toBe(center !== null);
      if (!center) return;
      count++;
      expect(largestDifference(numbersAt(centers, point, 3), center)).toBeLessThan(
        tolerances.float32,
      );
    });
    expect(count).toBeGreaterThan(points.length / 3);
  });

  it('are within a hundredth of its radius where its triangles are clustered', () => {
    const centers = restCenters(mesh, skin, quiet, 16);
    const misses = expected.map((center, point) =>
      center ? largestDifference(numbersAt(centers, point, 3), center) : 0,
    );
    expect(Math.max(...misses)).toBeLessThan(radius / 100);
    expect(Math.max(...misses)).toBeGreaterThan(0);
  });

  it('tell how far they are', () => {
    const parts: number[] = [];
    restCenters(mesh, skin, (part) => parts.push(part));
    expect(parts.length).toBeGreaterThan(2);
    expect(parts).toEqual(parts.toSorted((a, b) => a - b));
    expect(parts[0]).toBeGreaterThanOrEqual(0);
    expect(parts.at(-1)).toBeLessThanOrEqual(1);
  });
});

describe('the tube about its centers', () => {
  it.each([
    ['y', 150],
    ['x', 120],
  ] as const)('is, turned about %s by %d°, where the oracle puts it', (axis, angle) => {
    const { positions, q } = posed(axis, angle);
    const joints = jointMatrices(skeleton, q);
    const each = Array.from({ length: skeleton.jointCount }, (_, joint) => joint);
    const transforms: Transforms = {
      characterFromJoint: each.map((joint) => matrixAt(joints, joint)),
      jointFromBind: each.map((joint) => matrixAt(skin.jointFromBind, joint)),
      firstRoot: 0,
    };
    points.forEach((position, point) => {
      const vertex = {
        position,
        normal: [0, 1, 0],
        influences: rows[point]!,
        center: expected[point]!,
      };
      const found = numbersAt(positions, point, 3);
      expect(largestDifference(found, turnedAboutCenter(vertex, transforms))).toBeLessThan(1e-5);
    });
  });

  it.each([
    ['x', 90, 0.994],
    ['y', 150, 0.997],
  ] as const)('has, turned about %s by %d°, %f of its volume', (axis, angle, ratio) => {
    const found = volumeRatio(mesh, mesh.positions, posed(axis, angle).positions);
    expect(Math.abs(found! - ratio)).toBeLessThan(0.005);
  });
});
