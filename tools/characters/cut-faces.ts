import type { Corner, Face } from './pack-mesh.ts';
import type { Vector2, Vector3 } from './vector.ts';
import { mix } from './vector.ts';

/** A mesh that is being cut: cutting adds vertices at the ends of its lists. */
export interface CutMesh {
  readonly positions: Vector3[];
  /** The positions before the mesh was shaped, in which regions are outlined. */
  readonly unshaped: Vector3[];
  readonly textureCoordinates: Vector2[];
  /** For each vertex, its weight in each column. */
  readonly weights: (readonly number[])[];
  /** For each vertex, its mirror image in the plane x = 0, or itself. */
  readonly mirror: number[];
}

/** A cut this near to a vertex (as a part of the edge) goes through the vertex. */
const NEAREST = 0.06;

/**
 * Cuts faces along the curve where a value is zero, so that a region of a surface gets a smooth
 * outline. The value is positive inside and is interpolated along the edges. The two sides share
 * the vertices of the curve.
 *
 * @param valueAt of a corner; corners of one vertex have one value
 */
export function cutFaces(
  mesh: CutMesh,
  faces: readonly Face[],
  valueAt: (corner: Corner) => number,
): { inside: Face[]; outside: Face[] } {
  const values = new Map<number, number>();
  for (const corner of faces.flat()) values.set(corner.position, valueAt(corner));
  for (const face of faces) {
    for (const [a, b] of edgesOf(face)) snap(values, a.position, b.position);
  }
  const cuts = new EdgeCuts(mesh, values);
  const inside: Face[] = [];
  const outside: Face[] = [];
  for (const face of faces.flatMap((each) => simple(each, values))) {
    const [within, beyond] = [cuts.side(face, 1), cuts.side(face, -1)];
    if (within.length >= 3) inside.push(within);
    if (beyond.length >= 3) outside.push(beyond);
  }
  cuts.mirrorVertices();
  return { inside, outside };
}

function edgesOf(face: Face): [Corner, Corner][] {
  return face.map((corner, index) => [corner, face[(index + 1) % face.length]!]);
}

/** Moves the curve into a vertex that it nearly meets. */
function snap(values: Map<number, number>, a: number, b: number): void {
  const [valueA, valueB] = [values.get(a)!, values.get(b)!];
  if (valueA * valueB >= 0) return;
  const along = valueA / (valueA - valueB);
  if (along < NEAREST) values.set(a, 0);
  else if (along > 1 - NEAREST) values.set(b, 0);
}

/** A face that the curve enters twice is cut into triangles, which it can enter only once. */
function simple(face: Face, values: ReadonlyMap<number, number>): Face[] {
  const changes = edgesOf(face).filter(
    ([a, b]) => values.get(a.position)! * values.get(b.position)! < 0,
  );
  if (changes.length <= 2) return [face];
  return face.slice(2).map((corner, index) => [face[0]!, face[index + 1]!, corner]);
}

class EdgeCuts {
  /** From the two vertices of an edge to its new vertex; the same for texture coordinates. */
  private readonly vertices = new Map<string, number>();
  private readonly textures = new Map<string, number>();
  private readonly mesh: CutMesh;
  private readonly values: ReadonlyMap<number, number>;

  constructor(mesh: CutMesh, values: ReadonlyMap<number, number>) {
    this.mesh = mesh;
    this.values = values;
  }

  /** The part of a face where the value has this sign or is zero; empty if it has no area. */
  side(face: Face, sign: 1 | -1): Face {
    const valueOf = ({ position }: Corner): number => sign * this.values.get(position)!;
    if (!face.some((corner) => valueOf(corner) > 0)) return [];
    return edgesOf(face).flatMap(([a, b]) => [
      ...(valueOf(a) >= 0 ? [a] : []),
      ...(valueOf(a) * valueOf(b) < 0 ? [this.cut(a, b)] : []),
    ]);
  }

  /** The new vertices are mirror images of each other if their edges are. */
  mirrorVertices(): void {
    const { mirror } = this.mesh;
    for (const [key, vertex] of this.vertices) {
      const other = key.split(' ').map((end) => mirror[Number(end)] ?? Number(end));
      mirror[vertex] = this.vertices.get(keyOf(other[0]!, other[1]!)) ?? vertex;
    }
  }

  private cut(a: Corner, b: Corner): Corner {
    // Both faces of an edge compute the same numbers, whichever way they go along it.
    const [from, to] = a.position < b.position ? [a, b] : [b, a];
    const [valueFrom, valueTo] = [this.values.get(from.position)!, this.values.get(to.position)!];
    const along = valueFrom / (valueFrom - valueTo);
    return { position: this.vertex(from, to, along), texture: this.texture(from, to, along) };
  }

  private vertex(from: Corner, to: Corner, along: number): number {
    const { positions, unshaped, weights, mirror } = this.mesh;
    return addOnce(this.vertices, keyOf(from.position, to.position), () => {
      positions.push(mix(positions[from.position]!, positions[to.position]!, along));
      unshaped.push(mix(unshaped[from.position]!, unshaped[to.position]!, along));
      mirror.push(positions.length - 1);
      const [first, second] = [weights[from.position]!, weights[to.position]!];
      weights.push(first.map((weight, column) => weight + (second[column]! - weight) * along));
      return positions.length - 1;
    });
  }

  private texture(from: Corner, to: Corner, along: number): number {
    const { textureCoordinates } = this.mesh;
    return addOnce(this.textures, keyOf(from.texture, to.texture), () => {
      const [[u, v], [u2, v2]] = [
        textureCoordinates[from.texture]!,
        textureCoordinates[to.texture]!,
      ];
      return textureCoordinates.push([u + (u2 - u) * along, v + (v2 - v) * along]) - 1;
    });
  }
}

function keyOf(a: number, b: number): string {
  return a < b ? `${a} ${b}` : `${b} ${a}`;
}

function addOnce(known: Map<string, number>, key: string, add: () => number): number {
  const index = known.get(key) ?? add();
  known.set(key, index);
  return index;
}
