import type { ObjMesh, ObjPart } from './mit-text.ts';
import type { Vector2, Vector3 } from './vector.ts';

/** A corner of a face: indices from zero into the positions and the texture coordinates. */
export interface Corner {
  readonly position: number;
  readonly texture: number;
}

export type Face = readonly Corner[];

export interface SourceMesh {
  readonly positions: readonly Vector3[];
  readonly textureCoordinates: readonly Vector2[];
  readonly parts: readonly { readonly name: string; readonly faces: readonly Face[] }[];
  /** For each vertex, its mirror image in the plane x = 0, or itself. */
  readonly mirror?: readonly number[];
}

/** The mesh for the file and, for each of its vertices, the vertex of the source. */
export interface PackedMesh {
  readonly obj: ObjMesh;
  readonly sourceVertex: readonly number[];
}

/**
 * Orders vertices by their first use, each followed by its mirror image. The line of the mirror
 * image equals the one before it except for a sign, so gzip stores it in very few bytes.
 */
function orderVertices(faces: readonly Face[], mirror: readonly number[]): number[] {
  const used = new Set(faces.flat().map((corner) => corner.position));
  const order = new Set<number>();
  for (const { position } of faces.flat()) {
    if (order.has(position)) continue;
    order.add(position);
    const other = mirror[position] ?? position;
    if (used.has(other)) order.add(other);
  }
  return [...order];
}

/** Coordinates that are equal after rounding to the file's four decimals count as one. */
function textureKey(coordinate: Vector2): string {
  return coordinate.map((value) => value.toFixed(4)).join(' ');
}

/**
 * Keeps only the vertices that the parts use. Texture coordinates are numbered like the vertices as
 * far as possible, because `f 7/7 8/8 …` compresses well: vertex k's first coordinate has number k,
 * and those of other charts, along seams, come after all of these.
 */
export function packMesh(source: SourceMesh): PackedMesh {
  const allFaces = source.parts.flatMap((part) => part.faces);
  const sourceVertex = orderVertices(allFaces, source.mirror ?? []);
  const fileVertex = new Map(sourceVertex.map((vertex, index) => [vertex, index]));

  const textureCoordinates: Vector2[] = [];
  const textureOf = new Map<string, number>();
  for (const corner of allFaces.flat()) {
    const vertex = fileVertex.get(corner.position)!;
    if (textureCoordinates[vertex] !== undefined) continue;
    const coordinate = source.textureCoordinates[corner.texture]!;
    textureCoordinates[vertex] = coordinate;
    textureOf.set(`${vertex} ${textureKey(coordinate)}`, vertex);
  }
  const fileTexture = (vertex: number, coordinate: Vector2): number => {
    const key = `${vertex} ${textureKey(coordinate)}`;
    const known = textureOf.get(key);
    if (known !== undefined) return known;
    textureOf.set(key, textureCoordinates.length);
    return textureCoordinates.push(coordinate) - 1;
  };

  const parts: ObjPart[] = source.parts.map(({ name, faces }) => ({
    name,
    faces: faces.map((face) =>
      face.map((corner) => {
        const vertex = fileVertex.get(corner.position)!;
        return [vertex, fileTexture(vertex, source.textureCoordinates[corner.texture]!)] as const;
      }),
    ),
  }));
  const positions = sourceVertex.map((vertex) => source.positions[vertex]!);
  return { obj: { positions, textureCoordinates, parts }, sourceVertex };
}
