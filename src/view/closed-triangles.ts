import type { Mesh, Submesh } from '../core/mesh.ts';

/** The triangles of a mesh, those of closed surfaces first in each submesh. */
export interface ClosedTriangles {
  /** (triangleCount × 3) render vertices; within closed and open triangles the order stays. */
  readonly indices: Uint32Array;
  /** How many indices of each submesh belong to closed surfaces. */
  readonly closedCounts: ReadonlyMap<Submesh, number>;
}

/**
 * Finds the closed surfaces of a mesh: the connected parts in which every edge from a point to
 * another is matched by one in the other direction, and whose triangles are counterclockwise seen
 * from outside. A line of sight crosses their outer sides as often as their inner sides. Seen from
 * outside, inner sides can therefore be left out, and no pose makes a hole.
 */
export function closedTriangles(mesh: Mesh): ClosedTriangles {
  const { indices, pointOf, pointCount, positions, submeshes } = mesh;
  const parts = new Parts(pointCount);
  const corner = (index: number): number => pointOf[indices[index]!]!;
  const edges = new EdgeSums(indices.length);
  for (let first = 0; first < indices.length; first += 3) {
    for (let i = 0; i < 3; i++) {
      const from = corner(first + i);
      const to = corner(first + ((i + 1) % 3));
      parts.join(from, to);
      edges.add(from, to);
    }
  }
  const volumes = new Float64Array(pointCount);
  for (let first = 0; first < indices.length; first += 3) {
    volumes[parts.of(corner(first))]! += signedVolume(positions, indices, first);
  }
  const isOpen = new Uint8Array(pointCount);
  for (let part = 0; part < pointCount; part++) isOpen[part] = volumes[part]! > 0 ? 0 : 1;
  edges.forEachUnmatched((point) => (isOpen[parts.of(point)] = 1));

  const sorted = new Uint32Array(indices);
  const closedCounts = new Map<Submesh, number>();
  for (const submesh of submeshes) {
    let at = submesh.firstIndex;
    const take = (wanted: number): void => {
      const end = submesh.firstIndex + submesh.indexCount;
      for (let first = submesh.firstIndex; first < end; first += 3) {
        if (isOpen[parts.of(corner(first))] !== wanted) continue;
        for (let i = 0; i < 3; i++) sorted[at++] = indices[first + i]!;
      }
    };
    take(0);
    closedCounts.set(submesh, at - submesh.firstIndex);
    take(1);
  }
  return { indices: sorted, closedCounts };
}

/** Six times the volume between a triangle and the origin; summed, of what is inside a surface. */
function signedVolume(positions: Float32Array, indices: Uint32Array, first: number): number {
  const a = 3 * indices[first]!;
  const b = 3 * indices[first + 1]!;
  const c = 3 * indices[first + 2]!;
  const bx = positions[b]!;
  const by = positions[b + 1]!;
  const bz = positions[b + 2]!;
  const cx = positions[c]!;
  const cy = positions[c + 1]!;
  const cz = positions[c + 2]!;
  return (
    positions[a]! * (by * cz - bz * cy) +
    positions[a + 1]! * (bz * cx - bx * cz) +
    positions[a + 2]! * (bx * cy - by * cx)
  );
}

/** Sets of points that are connected by edges (Tarjan's disjoint sets). */
class Parts {
  private readonly parents: Uint32Array;

  constructor(pointCount: number) {
    this.parents = new Uint32Array(pointCount);
    for (let point = 0; point < pointCount; point++) this.parents[point] = point;
  }

  of(point: number): number {
    const { parents } = this;
    while (parents[point] !== point) point = parents[point] = parents[parents[point]!]!;
    return point;
  }

  join(a: number, b: number): void {
    this.parents[this.of(a)] = this.of(b);
  }
}

/** How often each edge is passed in one direction more than in the other. */
class EdgeSums {
  private readonly mask: number;
  private readonly lower: Int32Array;
  private readonly upper: Int32Array;
  private readonly sums: Int32Array;

  /** @param count how many edges are added at most */
  constructor(count: number) {
    const size = 2 ** Math.ceil(Math.log2(count * 1.5 + 2));
    this.mask = size - 1;
    this.lower = new Int32Array(size).fill(-1);
    this.upper = new Int32Array(size);
    this.sums = new Int32Array(size);
  }

  add(from: number, to: number): void {
    const { lower, upper, mask } = this;
    if (from === to) return;
    const a = Math.min(from, to);
    const b = Math.max(from, to);
    let slot = (Math.imul(a, 0x9e3779b1) ^ Math.imul(b, 0x85ebca6b)) & mask;
    while (lower[slot] !== -1 && (lower[slot] !== a || upper[slot] !== b)) slot = (slot + 1) & mask;
    lower[slot] = a;
    upper[slot] = b;
    this.sums[slot]! += from < to ? 1 : -1;
  }

  /** Calls back with one point of each edge that is not passed equally often both ways. */
  forEachUnmatched(found: (point: number) => void): void {
    this.sums.forEach((sum, slot) => {
      if (sum !== 0) found(this.lower[slot]!);
    });
  }
}
