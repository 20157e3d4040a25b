import { loadPart } from '../../core/failure.ts';
import type { MeshParts } from '../../core/character-parts.ts';
import { growInt32, growUint32 } from '../text/growable.ts';
import { needsEarClipping, triangulate } from './triangulate.ts';

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
  const faceCount = faces.ends.length;
  const polygonOf = (face: number): number[] => {
    const start = face === 0 ? 0 : faces.ends[face - 1]!;
    return Array.from(faces.points.subarray(start, faces.ends[face]));
  };
  let earClip: ((outline: readonly number[]) => number[]) | undefined;
  for (let face = 0; face < faceCount && !earClip; face++) {
    const polygon = polygonOf(face);
    if (!needsEarClipping(positions, polygon)) continue;
    earClip = (await loadPart(import('earcut'))).default;
  }

  const [points, uvs, normals] = [growUint32(), growInt32(), growInt32()];
  const firstTriangle = new Uint32Array(faceCount + 1);
  let degenerateCount = 0;
  for (let face = 0; face < faceCount; face++) {
    const polygon = polygonOf(face);
    const start = faces.ends[face]! - polygon.length;
    const order = triangulate(positions, polygon, earClip);
    for (let i = 0; i < order.length; i += 3) {
      const corners = [start + order[i]!, start + order[i + 1]!, start + order[i + 2]!];
      if (new Set(corners.map((corner) => faces.points[corner])).size < 3) {
        degenerateCount++;
        continue;
      }
      for (const corner of corners) {
        points.push(faces.points[corner]!);
        uvs.push(faces.uvs[corner]!);
        normals.push(faces.normals[corner]!);
      }
    }
    firstTriangle[face + 1] = points.length / 3;
  }
  return {
    corners: {
      cornerPoints: points.finish(),
      cornerUvs: uvs.finish(),
      cornerNormals: normals.finish(),
    },
    firstTriangle,
    degenerateCount,
  };
}
