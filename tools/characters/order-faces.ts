import type { Face } from './pack-mesh.ts';

/**
 * Orders faces so that a growing surface is stored, turn by turn around its edge: each face then
 * refers to vertices at about the same distances back as the one before it. A face is followed by
 * its mirror image.
 *
 * @param mirror for each vertex, its mirror image in the plane x = 0, or itself
 */
export function orderFaces(faces: readonly Face[], mirror: readonly number[]): Face[] {
  const facesAt = new Map<number, number[]>();
  for (const [index, face] of faces.entries()) {
    for (const { position } of face) {
      const others = facesAt.get(position);
      if (others) others.push(index);
      else facesAt.set(position, [index]);
    }
  }
  const byVertices = new Map(faces.map((face, index) => [keyOf(face, []), index]));
  const ordered: Face[] = [];
  const isDone = new Uint8Array(faces.length);
  const seen = new Set<number>();
  const edge: number[] = [];

  const take = (index: number | undefined): void => {
    if (index === undefined || isDone[index] === 1) return;
    isDone[index] = 1;
    const face = faces[index]!;
    ordered.push(face);
    for (const { position } of face) {
      if (!seen.has(position)) edge.push(position);
      seen.add(position).add(mirror[position] ?? position);
    }
    take(byVertices.get(keyOf(face, mirror)));
  };
  /** Of the faces left at a vertex, the one with the largest part of its corners seen. */
  const nextAt = (vertex: number): number | undefined => {
    const left = facesAt.get(vertex)!.filter((index) => isDone[index] === 0);
    const parts = left.map((index) => seenPart(faces[index]!, seen));
    return left[parts.indexOf(Math.max(...parts))];
  };
  for (let start = 0; start < faces.length; start++) {
    take(start);
    for (let at = 0; at < edge.length; at++) {
      for (let next = nextAt(edge[at]!); next !== undefined; next = nextAt(edge[at]!)) take(next);
    }
    edge.length = 0;
  }
  return ordered;
}

function seenPart(face: Face, seen: ReadonlySet<number>): number {
  return face.filter(({ position }) => seen.has(position)).length / face.length;
}

/** The vertices of the face or, with a mirror, of its mirror image, in any order. */
function keyOf(face: Face, mirror: readonly number[]): string {
  const vertices = face.map(({ position }) => mirror[position] ?? position);
  return vertices.sort((a, b) => a - b).join(' ');
}
