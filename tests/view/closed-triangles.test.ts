import { expect, test } from 'vitest';
import type { Mesh } from '../../src/core/mesh.ts';
import { closedTriangles } from '../../src/view/closed-triangles.ts';

// A tetrahedron, counterclockwise seen from outside.
const corners = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];
const faces = [
  [0, 2, 1],
  [0, 1, 3],
  [1, 2, 3],
  [2, 0, 3],
];

/** @param runs the triangles of each submesh, by render vertices */
function meshOf(positions: number[], runs: readonly number[][][], pointOf?: number[]): Mesh {
  const vertexCount = positions.length / 3;
  let firstIndex = 0;
  const submeshes = runs.map((triangles, index) => {
    const submesh = { material: `${index}`, firstIndex, indexCount: triangles.length * 3 };
    firstIndex += submesh.indexCount;
    return submesh;
  });
  const points = pointOf ?? Array.from({ length: vertexCount }, (_, vertex) => vertex);
  return {
    pointCount: Math.max(...points) + 1,
    vertexCount,
    pointOf: Uint32Array.from(points),
    positions: Float32Array.from(positions),
    normals: new Float32Array(positions.length),
    uvs: null,
    indices: Uint32Array.from(runs.flat(2)),
    submeshes,
  };
}

function closedCountsOf(mesh: Mesh): number[] {
  const { closedCounts } = closedTriangles(mesh);
  return mesh.submeshes.map((submesh) => closedCounts.get(submesh)!);
}

test('a tetrahedron is closed, also if its faces are spread over submeshes', () => {
  expect(closedCountsOf(meshOf(corners, [faces]))).toEqual([12]);
  expect(closedCountsOf(meshOf(corners, [faces.slice(0, 1), faces.slice(1)]))).toEqual([3, 9]);
});

test('render vertices that split a point do not open a surface', () => {
  const split = [...corners, ...corners.slice(0, 3)];
  const seamed = [[4, 2, 1], ...faces.slice(1)];
  expect(closedCountsOf(meshOf(split, [seamed], [0, 1, 2, 3, 0]))).toEqual([12]);
  expect(closedCountsOf(meshOf(split, [seamed]))).toEqual([0]);
});

test('a missing, turned or doubled face opens a surface, and so does turning all of them', () => {
  const turned = faces.map(([a, b, c]) => [a!, c!, b!]);
  for (const wrong of [
    faces.slice(1),
    [turned[0]!, ...faces.slice(1)],
    [...faces, faces[0]!],
    turned,
  ]) {
    expect(closedCountsOf(meshOf(corners, [wrong]))).toEqual([0]);
  }
});

test('a face without an area does not open a surface', () => {
  expect(closedCountsOf(meshOf(corners, [[...faces, [1, 1, 2]]]))).toEqual([15]);
  expect(closedCountsOf(meshOf(corners, [[...faces, [1, 1, 1]]]))).toEqual([15]);
});

test('the triangles of closed surfaces come first, each kind in its order', () => {
  const two = [...corners, ...corners.map((x) => x + 2)];
  const open = faces.slice(0, 3).map((face) => face.map((vertex) => vertex + 4));
  const mesh = meshOf(two, [
    [open[0]!, faces[0]!, open[1]!, ...faces.slice(1), open[2]!],
    [[0, 1, 4]],
  ]);
  // The last triangle connects the two and has free edges, so it opens both.
  expect(closedCountsOf(mesh)).toEqual([0, 0]);
  const apart = meshOf(two, [[open[0]!, faces[0]!, open[1]!, ...faces.slice(1), open[2]!]]);
  const { indices, closedCounts } = closedTriangles(apart);
  expect([...closedCounts.values()]).toEqual([12]);
  expect([...indices]).toEqual([...faces, ...open].flat());
});
