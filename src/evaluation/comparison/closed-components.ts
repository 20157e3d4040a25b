import { firstEqualFloats, firstEqualTuples } from '../../core/equal-tuples.ts';
import type { Mesh } from '../../core/mesh.ts';
import { enclosedVolume, surfaceArea } from './enclosed-volume.ts';

type Surface = Pick<Mesh, 'positions' | 'indices'>;

/** A part of the whole surface that is smaller has no volume of its own. */
const leastArea = 0.01;
/** A volume that is smaller, as a part of the area to the power of 3/2, is that of a folded sheet. */
const leastFullness = 1e-6;

/**
 * Finds the parts of a mesh that enclose a volume and have at least 1 % of its area: triangles that
 * hang together by their edges, where each edge is passed as often in one direction as in the other.
 * Vertices at one place at rest count as one, so that seams of textures do not open a surface.
 *
 * @returns of each part (triangleCount × 3) the corners, vertices that stand for all at their place
 */
export function closedComponents(mesh: Surface): readonly Uint32Array[] {
  let found = components.get(mesh);
  if (!found) components.set(mesh, (found = findComponents(mesh)));
  return found;
}

const components = new WeakMap<Surface, readonly Uint32Array[]>();

function findComponents({ positions, indices }: Surface): Uint32Array[] {
  const corners = weldedCorners(positions, indices);
  const least = leastArea * surfaceArea(positions, corners);
  return edgeComponents(corners).filter((part) => {
    const area = surfaceArea(positions, part);
    const volume = Math.abs(enclosedVolume(positions, part));
    return area > 0 && area >= least && volume > leastFullness * area ** 1.5;
  });
}

/** The corners of the triangles that have three places, of vertices at one place the first. */
export function weldedCorners(positions: Float32Array, indices: Uint32Array): Uint32Array {
  const first = firstEqualFloats(positions, 3);
  const corners = new Uint32Array(indices.length);
  let count = 0;
  for (let at = 0; at < indices.length; at += 3) {
    const a = first[indices[at]!]!;
    const b = first[indices[at + 1]!]!;
    const c = first[indices[at + 2]!]!;
    if (a === b || b === c || c === a) continue;
    corners[count++] = a;
    corners[count++] = b;
    corners[count++] = c;
  }
  return corners.subarray(0, count);
}

/** Returns the triangles that hang together by edges, if the edges close their surface. */
function edgeComponents(corners: Uint32Array): Uint32Array[] {
  const edges = new Int32Array(corners.length * 2);
  const directions = new Int8Array(corners.length);
  for (let corner = 0; corner < corners.length; corner++) {
    const from = corners[corner]!;
    const to = corners[corner % 3 === 2 ? corner - 2 : corner + 1]!;
    edges[corner * 2] = Math.min(from, to);
    edges[corner * 2 + 1] = Math.max(from, to);
    directions[corner] = from < to ? 1 : -1;
  }
  const first = firstEqualTuples(edges, 2);
  const owner = new Uint32Array(corners.length / 3).map((_, triangle) => triangle);
  const balance = new Int32Array(corners.length);
  for (let corner = 0; corner < corners.length; corner++) {
    const edge = first[corner]!;
    balance[edge]! += directions[corner]!;
    const a = rootOf(owner, third(corner));
    const b = rootOf(owner, third(edge));
    owner[Math.max(a, b)] = Math.min(a, b);
  }
  const isOpen = new Uint8Array(owner.length);
  for (let edge = 0; edge < balance.length; edge++) {
    if (balance[edge] !== 0) isOpen[rootOf(owner, third(edge))] = 1;
  }
  const counts = new Uint32Array(owner.length);
  for (let triangle = 0; triangle < owner.length; triangle++) counts[rootOf(owner, triangle)]!++;
  const parts = new Map<number, Uint32Array>();
  const next = new Uint32Array(owner.length);
  for (let triangle = 0; triangle < owner.length; triangle++) {
    const root = rootOf(owner, triangle);
    if (isOpen[root] === 1) continue;
    let part = parts.get(root);
    if (!part) parts.set(root, (part = new Uint32Array(counts[root]! * 3)));
    for (let i = 0; i < 3; i++) part[next[root]!++] = corners[triangle * 3 + i]!;
  }
  return [...parts.values()];
}

function third(corner: number): number {
  return Math.floor(corner / 3);
}

/** Finds who stands for a triangle, and shortens the way there. */
function rootOf(owner: Uint32Array, triangle: number): number {
  let root = triangle;
  while (owner[root] !== root) {
    owner[root] = owner[owner[root]!]!;
    root = owner[root]!;
  }
  return root;
}
