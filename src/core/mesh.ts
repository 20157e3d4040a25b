/**
 * A surface of *points* (in file order; skin rows, posed files and `.vertices()` count points) and
 * *render vertices*, which split a point only where texture coordinates or normals differ. The
 * first `pointCount` render vertices are the points themselves, in file order; the additional ones
 * follow.
 */
export interface Mesh {
  readonly pointCount: number;
  readonly vertexCount: number;
  /** (vertexCount) the point of each render vertex; the first pointCount values are 0, 1, 2, … */
  readonly pointOf: Uint32Array;
  /** (vertexCount × 3) bind pose, in model units and the character's space. */
  readonly positions: Float32Array;
  /**
   * (vertexCount × 3) unit, in the bind pose: the file's, or else angle-weighted means of the face
   * normals.
   */
  readonly normals: Float32Array;
  /** (vertexCount × 2), or null if the file has none. */
  readonly uvs: Float32Array | null;
  /** (triangleCount × 3) render vertices, counterclockwise seen from outside. */
  readonly indices: Uint32Array;
  readonly submeshes: readonly Submesh[];
}

export interface Submesh {
  readonly material: string;
  readonly firstIndex: number;
  readonly indexCount: number;
}

export const emptyMesh: Mesh = {
  pointCount: 0,
  vertexCount: 0,
  pointOf: new Uint32Array(0),
  positions: new Float32Array(0),
  normals: new Float32Array(0),
  uvs: null,
  indices: new Uint32Array(0),
  submeshes: [],
};
