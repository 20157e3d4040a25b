import { expect } from 'vitest';
import type { Mesh } from '../../src/core/mesh.ts';

/**
 * Expects closed surfaces: each edge is in two triangles, once in each direction.
 *
 * @returns the volume inside each, in cubic model units; positive if its triangles face outwards
 */
export function componentVolumes({ indices, positions, vertexCount }: Mesh): number[] {
  const edges = new Set<number>();
  const owner = Int32Array.from({ length: vertexCount }, (_, vertex) => vertex);
  const find = (vertex: number): number => {
    let root = vertex;
    while (owner[root] !== root) root = owner[root]!;
    owner[vertex] = root;
    return root;
  };
  for (let first = 0; first < indices.length; first += 3) {
    for (let corner = 0; corner < 3; corner++) {
      const [from, to] = [indices[first + corner]!, indices[first + ((corner + 1) % 3)]!];
      edges.add(from * vertexCount + to);
      owner[find(from)] = find(to);
    }
  }
  expect(edges.size).toBe(indices.length);
  for (const edge of edges) {
    const reverse = (edge % vertexCount) * vertexCount + Math.floor(edge / vertexCount);
    expect(edges.has(reverse)).toBe(true);
  }
  const volumes = new Map<number, number>();
  for (let first = 0; first < indices.length; first += 3) {
    const root = find(indices[first]!);
    const [a, b, c] = [0, 1, 2].map((corner) => {
      const at = indices[first + corner]! * 3;
      return positions.subarray(at, at + 3);
    });
    const [ax, ay, az] = a!;
    const [bx, by, bz] = b!;
    const [cx, cy, cz] = c!;
    const six =
      ax! * (by! * cz! - bz! * cy!) + ay! * (bz! * cx! - bx! * cz!) + az! * (bx! * cy! - by! * cx!);
    volumes.set(root, (volumes.get(root) ?? 0) + six / 6);
  }
  return [...volumes.values()];
}
