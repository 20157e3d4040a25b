import type { MeshParts } from './character-parts.ts';
import type { Mesh, Submesh } from './mesh.ts';
import { computeVertexNormals } from './vertex-normals.ts';

/**
 * Packs loose corners into render vertices: a point is split only where its corners differ in
 * texture coordinate or normal. Every point gets a render vertex, faces or not, so that skin rows
 * and posed files keep the file's order.
 */
export function buildMesh(parts: MeshParts): Mesh {
  const { cornerPoints, positions } = parts;
  const pointCount = positions.length / 3;
  const split = splitCorners(parts);
  const { pointOf, indices } = split;
  const vertexCount = pointOf.length;

  const vertexPositions = new Float32Array(vertexCount * 3);
  for (let vertex = 0; vertex < vertexCount; vertex++) {
    copyTriple(positions, pointOf[vertex]!, vertexPositions, vertex);
  }
  const pointNormals = new Float32Array(pointCount * 3);
  computeVertexNormals(positions, cornerPoints, pointNormals);
  return {
    pointCount,
    vertexCount,
    pointOf,
    positions: vertexPositions,
    normals: packNormals(parts, split, pointNormals),
    uvs: packUvs(parts, split),
    indices,
    submeshes: packSubmeshes(parts),
  };
}

interface Split {
  readonly pointOf: Uint32Array;
  readonly indices: Uint32Array;
  /** (vertexCount) index into the parts' uvs and normals, -1 where a vertex has none. */
  readonly uvOf: Int32Array;
  readonly normalOf: Int32Array;
}

function splitCorners(parts: MeshParts): Split {
  const { cornerPoints, uvs, cornerUvs, normals, cornerNormals } = parts;
  const pointCount = parts.positions.length / 3;
  const pointOf = Array.from({ length: pointCount }, (_, point) => point);
  const uvOf = new Array<number>(pointCount).fill(unset);
  const normalOf = new Array<number>(pointCount).fill(unset);
  // The render vertices of a point form a chain: most points have one, seams two or three.
  const nextOfPoint = new Array<number>(pointCount).fill(-1);
  const indices = new Uint32Array(cornerPoints.length);

  for (let corner = 0; corner < cornerPoints.length; corner++) {
    const point = cornerPoints[corner]!;
    const uv = cornerUvs ? cornerUvs[corner]! : -1;
    const normal = cornerNormals ? cornerNormals[corner]! : -1;
    const fits = (vertex: number): boolean =>
      uvOf[vertex] === unset ||
      (sameTuple(uvs, 2, uvOf[vertex]!, uv) && sameTuple(normals, 3, normalOf[vertex]!, normal));
    let vertex = point;
    while (!fits(vertex)) {
      if (nextOfPoint[vertex] === -1) {
        nextOfPoint[vertex] = pointOf.length;
        pointOf.push(point);
        uvOf.push(unset);
        normalOf.push(unset);
        nextOfPoint.push(-1);
      }
      vertex = nextOfPoint[vertex]!;
    }
    uvOf[vertex] = uv;
    normalOf[vertex] = normal;
    indices[corner] = vertex;
  }
  return {
    pointOf: Uint32Array.from(pointOf),
    indices,
    uvOf: Int32Array.from(uvOf),
    normalOf: Int32Array.from(normalOf),
  };
}

const unset = -2;

/** Whether two corners agree: files often repeat a value under another index. */
function sameTuple(values: Float32Array | undefined, size: number, a: number, b: number): boolean {
  if (!values || a === b || a < 0 || b < 0) return a === b;
  for (let i = 0; i < size; i++) {
    if (values[a * size + i] !== values[b * size + i]) return false;
  }
  return true;
}

function packNormals(parts: MeshParts, split: Split, pointNormals: Float32Array): Float32Array {
  const packed = new Float32Array(split.pointOf.length * 3);
  for (let vertex = 0; vertex < split.pointOf.length; vertex++) {
    const normal = split.normalOf[vertex]!;
    const fromFile = parts.normals !== undefined && normal >= 0;
    if (fromFile && copyUnit(parts.normals, normal, packed, vertex)) continue;
    copyTriple(pointNormals, split.pointOf[vertex]!, packed, vertex);
  }
  return packed;
}

function packUvs(parts: MeshParts, split: Split): Float32Array | null {
  if (!parts.uvs || !parts.cornerUvs) return null;
  const packed = new Float32Array(split.pointOf.length * 2);
  split.uvOf.forEach((uv, vertex) => {
    if (uv < 0) return;
    packed[vertex * 2] = parts.uvs![uv * 2]!;
    packed[vertex * 2 + 1] = parts.uvs![uv * 2 + 1]!;
  });
  return packed;
}

function packSubmeshes(parts: MeshParts): Submesh[] {
  const triangleCount = parts.cornerPoints.length / 3;
  const runs = parts.submeshes ?? [{ material: '', firstTriangle: 0 }];
  return runs
    .map(({ material, firstTriangle }, index) => {
      const end = runs[index + 1]?.firstTriangle ?? triangleCount;
      return { material, firstIndex: firstTriangle * 3, indexCount: (end - firstTriangle) * 3 };
    })
    .filter(({ indexCount }) => indexCount > 0);
}

function copyTriple(from: Float32Array, source: number, to: Float32Array, target: number): void {
  for (let i = 0; i < 3; i++) to[target * 3 + i] = from[source * 3 + i]!;
}

/** Copies a normal made unit; false where it has no length. */
function copyUnit(from: Float32Array, source: number, to: Float32Array, target: number): boolean {
  const [x, y, z] = [from[source * 3]!, from[source * 3 + 1]!, from[source * 3 + 2]!];
  const length = Math.hypot(x, y, z);
  if (!(length > 1e-12)) return false;
  const scale = Math.abs(length - 1) < 1e-6 ? 1 : 1 / length; // so that unit ones keep their bits
  to.set([x * scale, y * scale, z * scale], target * 3);
  return true;
}
