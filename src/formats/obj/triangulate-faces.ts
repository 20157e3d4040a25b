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
  /** The number of triangles before each of the given faces. */
  readonly firstTriangles: readonly number[];
  /** The number of triangles with fewer than three different points, which are left out. */
  readonly degenerateCount: number;
}

/**
 * Cuts faces of three corners or more into triangles, in order. The library for ear clipping is
 * loaded only when a face needs it; quads and convex faces do not.
 *
 * @param positions (pointCount × 3)
 * @param runs faces for which the number of triangles before them is wanted, in order
 */
export async function triangulateFaces(
  faces: FaceCorners,
  positions: Float32Array,
  runs: readonly number[],
): Promise<FaceTriangles> {
  const { points, uvs, normals, ends } = faces;
  const faceCount = ends.length;
  if (areTriangles(faces)) {
    const corners = { cornerPoints: points, cornerUvs: uvs, cornerNormals: normals };
    return { corners, firstTriangles: runs, degenerateCount: 0 };
  }
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
  // The corners of all triangles, as indices into those of the faces.
  const order = new Uint32Array(most);
  const firstTriangles: number[] = [];
  let filled = 0;
  let degenerateCount = 0;
  for (let face = 0; face < faceCount; face++) {
    while (runs[firstTriangles.length] === face) firstTriangles.push(filled / 3);
    const start = startOf(face);
    const count = ends[face]! - start;
    if (count === 3) add(start, start + 1, start + 2);
    else if (count === 4) addQuad(start);
    else {
      const triangles = triangulate(positions, polygonOf(face), earClip);
      for (let i = 0; i < triangles.length; i += 3) {
        add(start + triangles[i]!, start + triangles[i + 1]!, start + triangles[i + 2]!);
      }
    }
  }
  while (firstTriangles.length < runs.length) firstTriangles.push(filled / 3);
  const cornerPoints = new Uint32Array(filled);
  const cornerUvs = new Int32Array(filled);
  const cornerNormals = new Int32Array(filled);
  for (let i = 0; i < filled; i++) {
    const corner = order[i]!;
    cornerPoints[i] = points[corner]!;
    cornerUvs[i] = uvs[corner]!;
    cornerNormals[i] = normals[corner]!;
  }
  return { corners: { cornerPoints, cornerUvs, cornerNormals }, firstTriangles, degenerateCount };

  function addQuad(start: number): void {
    const a = points[start]!;
    const b = points[start + 1]!;
    const c = points[start + 2]!;
    const d = points[start + 3]!;
    const from = quadStart(positions, a, b, c, d);
    const across = start + ((from + 2) % 4);
    add(start + from, start + ((from + 1) % 4), across);
    add(start + from, across, start + ((from + 3) % 4));
  }

  function add(a: number, b: number, c: number): void {
    if (isDegenerate(points[a]!, points[b]!, points[c]!)) {
      degenerateCount++;
      return;
    }
    order[filled++] = a;
    order[filled++] = b;
    order[filled++] = c;
  }
}

/** Whether there is nothing to cut or to leave out, as in most large files. */
function areTriangles({ points, ends }: FaceCorners): boolean {
  if (points.length !== ends.length * 3) return false;
  for (let i = 0; i < points.length; i += 3) {
    if (isDegenerate(points[i]!, points[i + 1]!, points[i + 2]!)) return false;
  }
  return true;
}

function isDegenerate(a: number, b: number, c: number): boolean {
  return a === b || b === c || c === a;
}
