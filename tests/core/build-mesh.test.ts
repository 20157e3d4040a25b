import { describe, expect, it } from 'vitest';
import { buildMesh } from '../../src/core/build-mesh.ts';
import type { MeshParts } from '../../src/core/character-parts.ts';
import type { Mesh } from '../../src/core/mesh.ts';
import { cpuTime } from '../support/cpu-time.ts';
import { numbersAt } from '../support/compare.ts';

/** Two triangles that share the edge 1 2, and a fifth point that no face uses. */
const square: MeshParts = {
  file: 'a.obj',
  positions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 9, 9, 9),
  cornerPoints: Uint32Array.of(0, 1, 2, 2, 1, 3),
};

function expectSound(mesh: Mesh): void {
  const points = Array.from({ length: mesh.pointCount }, (_, point) => point);
  expect([...mesh.pointOf.subarray(0, mesh.pointCount)]).toEqual(points);
  mesh.pointOf.forEach((point, vertex) => {
    expect(numbersAt(mesh.positions, vertex, 3)).toEqual(numbersAt(square.positions, point, 3));
  });
  const corners = Array.from(mesh.indices, (vertex) => mesh.pointOf[vertex]);
  expect(corners).toEqual([...square.cornerPoints]);
}

describe('buildMesh', () => {
  it('makes one render vertex per point if there are no seams', () => {
    const mesh = buildMesh(square);
    expectSound(mesh);
    expect(mesh).toMatchObject({ pointCount: 5, vertexCount: 5, uvs: null });
    expect(numbersAt(mesh.normals, 1, 3)).toEqual([0, 0, 1]);
    expect(mesh.submeshes).toEqual([{ material: '', firstIndex: 0, indexCount: 6 }]);
  });

  it('splits a point at a seam of texture coordinates, after all points', () => {
    const mesh = buildMesh({
      ...square,
      uvs: Float32Array.of(0, 0, 1, 0, 0, 1, 0.5, 0.25),
      cornerUvs: Int32Array.of(0, 1, 2, 2, 3, -1),
    });
    expectSound(mesh);
    expect(mesh.vertexCount).toBe(6);
    expect([...mesh.indices]).toEqual([0, 1, 2, 2, 5, 3]);
    expect(mesh.pointOf[5]).toBe(1);
    expect(numbersAt(mesh.uvs!, 1, 2)).toEqual([1, 0]);
    expect(numbersAt(mesh.uvs!, 5, 2)).toEqual([0.5, 0.25]);
    expect(numbersAt(mesh.uvs!, 3, 2)).toEqual([0, 0]);
  });

  it('splits a point at a seam of normals and makes them unit', () => {
    const mesh = buildMesh({
      ...square,
      normals: Float32Array.of(0, 0, 2, 0, 3, 0, 0, 0, 0),
      cornerNormals: Int32Array.of(0, 0, 0, 0, 1, 2),
    });
    expectSound(mesh);
    expect(mesh.vertexCount).toBe(6);
    expect(numbersAt(mesh.normals, 1, 3)).toEqual([0, 0, 1]);
    expect(numbersAt(mesh.normals, 5, 3)).toEqual([0, 1, 0]);
    // A normal of length zero is replaced by that of the faces.
    expect(numbersAt(mesh.normals, 3, 3)).toEqual([0, 0, 1]);
  });

  it('splits only where values differ, not where a file repeats equal ones', () => {
    const mesh = buildMesh({
      ...square,
      uvs: Float32Array.of(0, 0, 1, 0, 0, 1, 0, 1, 1, 0, 1, 1),
      cornerUvs: Int32Array.of(0, 1, 2, 3, 4, 5),
      normals: Float32Array.of(0, 0, 1, 0, 0, 1),
      cornerNormals: Int32Array.of(0, 0, 0, 1, 1, 1),
    });
    expectSound(mesh);
    expect(mesh.vertexCount).toBe(5);
  });

  it('splits one point at thousands of seams in time that does not grow with their square', async () => {
    // A fan in which each triangle gives the center another texture coordinate.
    const count = 40_000;
    const fan: MeshParts = {
      file: 'a.obj',
      positions: Float32Array.from({ length: (count + 2) * 3 }, (_, i) => Math.sin(i)),
      cornerPoints: Uint32Array.from({ length: count * 3 }, (_, i) => {
        return i % 3 === 0 ? 0 : Math.floor(i / 3) + (i % 3);
      }),
      uvs: Float32Array.from({ length: count * 2 }, (_, i) => i),
      cornerUvs: Int32Array.from({ length: count * 3 }, (_, i) => (i % 3 ? 0 : i / 3)),
    };
    // About 20 times the usual time; an algorithm that is quadratic in the seams would take a
    // minute.
    expect(await cpuTime(() => buildMesh(fan))).toBeLessThan(3000);
    expect(buildMesh(fan).vertexCount).toBe(count + 2 + count - 1);
  });

  it('keeps unit normals bit by bit, and flushes what GPUs flush', () => {
    const unit = [0.6, 0.8, 0].map(Math.fround);
    const mesh = buildMesh({
      ...square,
      positions: Float32Array.of(0, 1e-40, -1e-45, 1, 0, 0, 0, 1, 0, 1, 1, 0, 9, 9, 9),
      uvs: Float32Array.of(1e-39, 1),
      cornerUvs: new Int32Array(6),
      normals: Float32Array.of(...unit, 1, 1e-39, 0),
      cornerNormals: Int32Array.of(0, 0, 0, 1, 1, 1),
    });
    expect(numbersAt(mesh.positions, 0, 3)).toEqual([0, 0, 0]);
    expect(numbersAt(mesh.uvs!, 0, 2)).toEqual([0, 1]);
    expect(numbersAt(mesh.normals, 0, 3)).toEqual(unit);
    expect(numbersAt(mesh.normals, 3, 3)).toEqual([1, 0, 0]);
  });

  it('makes a submesh of each run of a material and none of an empty run', () => {
    const submeshes = [
      { material: 'red', firstTriangle: 0 },
      { material: 'empty', firstTriangle: 1 },
      { material: 'blue', firstTriangle: 1 },
    ];
    expect(buildMesh({ ...square, submeshes }).submeshes).toEqual([
      { material: 'red', firstIndex: 0, indexCount: 3 },
      { material: 'blue', firstIndex: 3, indexCount: 3 },
    ]);
  });
});
