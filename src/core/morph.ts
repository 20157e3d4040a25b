import type { MorphParts } from './character-parts.ts';
import type { Mesh } from './mesh.ts';

/** A morph target: weighted offsets that are added to some render vertices of the mesh at rest. */
export interface Morph {
  readonly name: string;
  /** The morph as read, for writers. */
  readonly parts: MorphParts;
  /** (n) render vertices. */
  readonly vertices: Uint32Array;
  /** (n × 3) model units. */
  readonly offsets: Float32Array;
  /** (m) render vertices, and (m × 3) offsets that are added to their unit normals. */
  readonly normalVertices: Uint32Array;
  readonly normalOffsets: Float32Array;
}

/**
 * Converts a morph of points to one of render vertices, because a point may be split into several.
 */
export function buildMorph(parts: MorphParts, mesh: Mesh): Morph {
  const splits = splitsOf(mesh);
  const positions = spread(parts.points, parts.offsets, splits);
  const normals = spread(parts.normalPoints, parts.normalOffsets, splits);
  return {
    name: parts.name,
    parts,
    vertices: positions.vertices,
    offsets: positions.offsets,
    normalVertices: normals.vertices,
    normalOffsets: normals.offsets,
  };
}

/** The additional render vertices of points that were split. */
function splitsOf({ pointOf, pointCount, vertexCount }: Mesh): Map<number, number[]> {
  const splits = new Map<number, number[]>();
  for (let vertex = pointCount; vertex < vertexCount; vertex++) {
    const point = pointOf[vertex]!;
    const others = splits.get(point);
    if (others) others.push(vertex);
    else splits.set(point, [vertex]);
  }
  return splits;
}

function spread(
  points: Uint32Array,
  offsets: Float32Array,
  splits: ReadonlyMap<number, readonly number[]>,
): { vertices: Uint32Array; offsets: Float32Array } {
  const vertices: number[] = [];
  const values: number[] = [];
  points.forEach((point, index) => {
    for (const vertex of [point, ...(splits.get(point) ?? [])]) {
      vertices.push(vertex);
      for (let i = 0; i < 3; i++) values.push(offsets[index * 3 + i]!);
    }
  });
  return { vertices: Uint32Array.from(vertices), offsets: Float32Array.from(values) };
}
