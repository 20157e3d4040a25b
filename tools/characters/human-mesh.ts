import type { BaseMesh, Face } from './makehuman-source.ts';
import type { ObjMesh, ObjPart } from './mit-text.ts';
import { PARTS } from './human-shape.ts';
import type { Vector2, Vector3 } from './vector.ts';

/** The mesh for the file and, for each of its vertices, the vertex of the base mesh it was. */
export interface HumanMesh {
  readonly obj: ObjMesh;
  readonly baseVertex: readonly number[];
}

function facesOf(mesh: BaseMesh, groups: readonly string[]): Face[] {
  return groups.flatMap((group) => {
    const faces = mesh.groups.get(group);
    if (faces === undefined) throw new Error(`the base mesh has no group ${group}`);
    return faces;
  });
}

/**
 * Vertices in the order of their first use, each followed by its mirror image: its line in the file
 * is then the line before but for the sign, and gzip stores it in almost nothing.
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

/** What is equal after rounding to the file's four decimals is one coordinate there. */
function textureKey(coordinate: Vector2): string {
  return coordinate.map((value) => value.toFixed(4)).join(' ');
}

/**
 * Keeps the figure's parts and only the vertices that they use. Texture coordinates are numbered
 * like the vertices as far as that goes (`f 7/7 8/8 …` packs well): vertex k's first coordinate is
 * number k, and those of further charts, along seams, come after all of them.
 *
 * @param place takes a point of the base mesh to file space
 */
export function buildHumanMesh(
  base: BaseMesh,
  mirror: readonly number[],
  place: (point: Vector3) => Vector3,
): HumanMesh {
  const parts = PARTS.map(({ name, groups }) => ({ name, faces: facesOf(base, groups) }));
  const allFaces = parts.flatMap((part) => part.faces);
  const baseVertex = orderVertices(allFaces, mirror);
  const fileVertex = new Map(baseVertex.map((vertex, index) => [vertex, index]));

  const textureCoordinates: Vector2[] = [];
  const textureOf = new Map<string, number>();
  for (const corner of allFaces.flat()) {
    const vertex = fileVertex.get(corner.position)!;
    if (textureCoordinates[vertex] !== undefined) continue;
    const coordinate = base.textureCoordinates[corner.texture]!;
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

  const objParts: ObjPart[] = parts.map(({ name, faces }) => ({
    name,
    faces: faces.map((face) =>
      face.map((corner) => {
        const vertex = fileVertex.get(corner.position)!;
        return [vertex, fileTexture(vertex, base.textureCoordinates[corner.texture]!)] as const;
      }),
    ),
  }));
  const positions = baseVertex.map((vertex) => place(base.positions[vertex]!));
  return { obj: { positions, textureCoordinates, parts: objParts }, baseVertex };
}
