import type { MeshParts } from './character-parts.ts';
import { firstEqualFloats } from './equal-tuples.ts';
import { flushSubnormal } from './float32.ts';
import { computeVertexNormals } from './vertex-normals.ts';

/** Texture coordinates or normals, with an index for each corner; equal values share one index. */
export interface CornerValues {
  /** (n × size) */
  readonly values: Float32Array;
  /** (cornerCount) */
  readonly ofCorner: Int32Array;
  /** (pointCount) values of points that no corner uses. */
  readonly ofPoint: Int32Array;
}

/** A corner without a texture coordinate gets (0, 0). */
export function cornerUvs(parts: MeshParts): CornerValues | undefined {
  const { positions, uvs, cornerUvs: corners } = parts;
  if (!uvs || !corners) return undefined;
  const values = new Float32Array(uvs.length + 2);
  values.set(uvs.map(flushSubnormal));
  const first = firstEqualFloats(values, 2);
  const none = first[uvs.length / 2]!;
  return {
    values,
    ofCorner: corners.map((uv) => (uv < 0 ? none : first[uv]!)),
    ofPoint: new Int32Array(positions.length / 3).fill(none),
  };
}

/**
 * The file's normals, normalized. A corner without a normal, or with one of length zero, gets its
 * point's normal, which is computed from the faces.
 */
export function cornerNormals(parts: MeshParts, positions: Float32Array): CornerValues {
  const { cornerPoints, normals, cornerNormals: corners } = parts;
  const computed = new Float32Array(positions.length);
  computeVertexNormals(positions, cornerPoints, computed);
  const points = new Int32Array(positions.length / 3);
  for (let point = 0; point < points.length; point++) points[point] = point;
  if (!normals || !corners) {
    return { values: computed, ofCorner: new Int32Array(cornerPoints), ofPoint: points };
  }
  const givenCount = normals.length / 3;
  const values = new Float32Array(normals.length + computed.length);
  values.set(computed, normals.length);
  const hasLength = new Uint8Array(givenCount);
  for (let index = 0; index < givenCount; index++) {
    hasLength[index] = Number(copyUnit(normals, values, index));
  }
  const first = firstEqualFloats(values, 3);
  const ofPoint = points.map((point) => first[givenCount + point]!);
  return {
    values,
    ofCorner: corners.map((normal, corner) =>
      normal >= 0 && hasLength[normal] === 1 ? first[normal]! : ofPoint[cornerPoints[corner]!]!,
    ),
    ofPoint,
  };
}

/**
 * Copies a normal and normalizes it; a unit normal keeps its exact bits. Returns false if it has no
 * length.
 */
function copyUnit(from: Float32Array, to: Float32Array, index: number): boolean {
  const at = index * 3;
  const length = Math.hypot(from[at]!, from[at + 1]!, from[at + 2]!);
  if (!(length > 1e-12)) return false;
  const scale = Math.abs(length - 1) < 1e-6 ? 1 : 1 / length;
  for (let i = at; i < at + 3; i++) to[i] = flushSubnormal(from[i]! * scale);
  return true;
}
