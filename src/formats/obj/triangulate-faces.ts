import { loadPart } from '../../core/failure.ts';
import type { MeshParts } from '../../core/character-parts.ts';
import { needsEarClipping, quadStart, triangulate } from './triangulate.ts';

/** The corners of all faces, one face after another. */
export interface FaceCorners {
  readonly points: Uint32Array;
  /** −1 if a corner has none. */
  readonly uvs: Int32Array;
  /** −1 if a corner has none. */
  readonly normals: Int32Array;
  /** (faceCount) the index after the last corner of each face. */
  readonly ends: Uint32Array;
}

export interface FaceTriangles {
  readonly corners: Pick<MeshParts, 'cornerPoints' | 'cornerUvs' | 'cornerNormals'>;
  /** (faceCount + 1) the number of triangles before each face. */
  readonly firstTriangle: Uint32Array;
  /** The number of triangles with fewer than three different points, which are left out. */
  readonly degenerateCount: number;
}

/**
 * Cuts faces of three corners or more into triangles, in order. The library for ear clipping is
 * loaded only when a face needs it; quads and convex faces do not.
 *
 * @param positions (pointCount × 3)
 */
export async function triangulateFaces(
  faces: FaceCorners,
  positions: Float32Array,
): Promise<FaceTriangles> {
  const { points, uvs, normals, ends } = faces;
  const faceCount = ends.length;
  const startOf = (face: number): number => (face === 0 ? 0 : ends[face - 1]!);
  const polygonOf = (face: number): number[] =>
    Array.from(points.subarray(startOf(face), ends[face]));
  let earClip: ((outline: readonly number[]) => number[]) | undefined;
  for (let face = 0; face < faceCount && !earClip; face++) {
    if (ends[face]! - startOf(face) <= 4) continue;
    if (!needsEarClipping(positions, polygonOf(face))) continue;
    earClip = (await loadPart(import('earcut'))).default;
  }

  const most = Math.max(0, points.length - 2 * faceCount) * 3;
  const cornerPoints = new Uint32Array(most);
  const cornerUvs = new Int32Array(most);
  const cornerNormals = new Int32Array(most);
  const firstTriangle = new Uint32Array(faceCount + 1);
  let filled = 0;
  let degenerateCount = 0;
  for (let face = 0; face < faceCount; face++) {
    const start = startOf(face);
    const count = ends[face]! - start;
    if (count === 3) add(start, start + 1, start + 2);
    else if (count === 4) addQuad(start);
    else {
      const order = triangulate(positions, polygonOf(face), earClip);
      for (let i = 0; i < order.length; i += 3) {
        add(start + order[i]!, start + order[i + 1]!, start + order[i + 2]!);
      }
    }
    firstTriangle[face + 1] = filled / 3;
  }
  return {
    corners: {
      cornerPoints: cornerPoints.slice(0, filled),
      cornerUvs: cornerUvs.slice(0, filled),
      cornerNormals: cornerNormals.slice(0, filled),
    },
    firstTriangle,
    degenerateCount,
  };

  function addQuad(start: number): void {
    const [a, b] = [points[start]!, points[start + 1]!];
    const [c, d] = [points[start + 2]!, points[start + 3]!];
    const from = quadStart(positions, a, b, c, d);
    const across = start + ((from + 2) % 4);
    add(start + from, start + ((from + 1) % 4), across);
    add(start + from, across, start + ((from + 3) % 4));
  }

  function add(a: number, b: number, c: number): void {
    if (points[a] === points[b] || points[b] === points[c] || points[c] === points[a]) {
      degenerateCount++;
      return;
    }
    put(a);
    put(b);
    put(c);
  }

  function put(corner: number): void {
    cornerPoints[filled] = points[corner]!;
    cornerUvs[filled] = uvs[corner]!;
    cornerNormals[filled++] = normals[corner]!;
  }
}
