import { growInt32, growUint32 } from '../text/growable.ts';
import type { PlainCorners } from './plain-corners.ts';
import { resolveIndex } from './resolve-index.ts';
import type { FaceCorners } from './triangulate-faces.ts';
import type { ObjStreams } from './tuple-stream.ts';

/** Collects the corners of faces. Those of a face that turns out wrong are taken back. */
export class FaceList {
  private readonly points: ReturnType<typeof growUint32>;
  /** Both are filled up to the last corner that has one. */
  private readonly uvs = growInt32();
  private readonly normals = growInt32();
  private readonly ends = growUint32();
  private readonly mostTriangles: number;

  /** @param cornerCount about as many as are expected */
  constructor(mostTriangles: number, cornerCount: number) {
    this.points = growUint32(cornerCount);
    this.mostTriangles = mostTriangles;
  }

  get count(): number {
    return this.ends.length;
  }

  /** Adds a corner of the next face; -1 stands for no texture coordinate or normal. */
  addCorner(point: number, uv: number, normal: number): void {
    const { points, uvs, normals } = this;
    if (uv >= 0) {
      uvs.padTo(points.length, -1);
      uvs.push(uv);
    }
    if (normal >= 0) {
      normals.padTo(points.length, -1);
      normals.push(normal);
    }
    points.push(point);
  }

  /**
   * Adds a face. Returns false if an index of its corners does not exist, or if it would exceed the
   * limit on triangles; its corners then have to be taken back.
   */
  addFace(corners: PlainCorners, { positions, uvs, normals }: ObjStreams): boolean {
    const start = this.points.length;
    return (
      addIndices(this.points, corners, 0, positions.count, start) &&
      (!corners.hasUvs || addIndices(this.uvs, corners, 1, uvs.count, start)) &&
      (!corners.hasNormals || addIndices(this.normals, corners, 2, normals.count, start)) &&
      this.closeFace()
    );
  }

  /** Makes a face of the open corners; returns false if it would exceed the limit on triangles. */
  closeFace(): boolean {
    if (this.points.length - 2 * (this.count + 1) > this.mostTriangles) return false;
    this.ends.push(this.points.length);
    return true;
  }

  /** Takes back the open corners. */
  dropCorners(): void {
    const { firstOpen } = this;
    for (const values of [this.points, this.uvs, this.normals]) {
      values.length = Math.min(values.length, firstOpen);
    }
  }

  finish(): FaceCorners {
    const { points, uvs, normals } = this;
    // Most files without the one have not the other either.
    const none = new Int32Array(uvs.length * normals.length === 0 ? points.length : 0).fill(-1);
    return {
      points: points.finish(),
      uvs: uvs.length === 0 ? none : padded(uvs, points.length),
      normals: normals.length === 0 ? none : padded(normals, points.length),
      ends: this.ends.finish(),
    };
  }

  private get firstOpen(): number {
    return this.count === 0 ? 0 : this.ends.at(this.count - 1);
  }
}

/** Adds one field of all corners of a face; returns false if an index does not exist. */
function addIndices(
  list: ReturnType<typeof growInt32> | ReturnType<typeof growUint32>,
  { indices, count }: PlainCorners,
  field: number,
  tupleCount: number,
  start: number,
): boolean {
  list.padTo(start, -1);
  const values = list.reserve(count);
  for (let corner = 0; corner < count; corner++) {
    const index = indices[corner * 3 + field]!;
    const resolved = resolveIndex(index, tupleCount);
    if (resolved === -1 && index !== 0) return false;
    values[start + corner] = resolved;
  }
  list.length = start + count;
  return true;
}

function padded(list: ReturnType<typeof growInt32>, length: number): Int32Array {
  list.padTo(length, -1);
  return list.finish();
}
