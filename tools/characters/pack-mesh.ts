import { decimal } from './mit-text.ts';
import { orderFaces } from './order-faces.ts';
import { subtract, type Vector2, type Vector3 } from './vector.ts';

/** A corner of a face: indices from zero into the positions and the texture coordinates. */
export interface Corner {
  readonly position: number;
  readonly texture: number;
}

/** The corners counterclockwise, seen from outside. */
export type Face = readonly Corner[];

export interface SourceMesh {
  /** In meters. */
  readonly positions: readonly Vector3[];
  readonly textureCoordinates: readonly Vector2[];
  /** The faces of each material. */
  readonly parts: readonly { readonly name: string; readonly faces: readonly Face[] }[];
  /** For each vertex, its mirror image in the plane x = 0, or itself. */
  readonly mirror?: readonly number[];
}

/** The text of an `.obj` and, for each of its vertices, the vertex of the source. */
export interface PackedMesh {
  readonly text: string;
  readonly sourceVertex: readonly number[];
}

/** A thousandth of the texture's side is half a pixel of the textures that come with characters. */
const TEXTURE_DECIMALS = 3;

/**
 * A tenth of a millimeter is finer than anyone can see, but it tilts faces whose edges are shorter
 * than this, in meters.
 */
const SHORT_EDGE = 0.006;
const [DECIMALS, FINE_DECIMALS] = [4, 5];

/**
 * Writes a mesh so that it compresses well. Each vertex is written before the first face that uses
 * it, with its texture coordinate, and faces count both back from where they are: faces side by
 * side then have nearly equal lines. Along seams, a vertex has further texture coordinates; these
 * are at the beginning, and are counted from there. Only vertices that faces use are kept.
 *
 * @param library the material library's name
 */
export function packMesh(source: SourceMesh, library?: string): PackedMesh {
  const mirror = source.mirror ?? [];
  const parts = source.parts.map(({ name, faces }) => ({ name, faces: orderFaces(faces, mirror) }));
  const faces = parts.flatMap((part) => part.faces);
  const textOf = ({ texture }: Corner): string =>
    source.textureCoordinates[texture]!.map((value) => decimal(value, TEXTURE_DECIMALS)).join(' ');
  const mainTexture = mainTextures(faces, textOf);
  const seams = new Map<string, number>();
  for (const corner of faces.flat()) {
    const text = textOf(corner);
    if (text !== mainTexture.get(corner.position) && !seams.has(text)) seams.set(text, seams.size);
  }
  const edges = shortestEdges(source.positions, faces);

  const lines = library === undefined ? [] : [`mtllib ${library}`];
  for (const text of seams.keys()) lines.push(`vt ${text}`);
  const fileVertex = new Map<number, number>();
  for (const part of parts) {
    lines.push(`usemtl ${part.name}`);
    for (const face of part.faces) {
      for (const { position } of face) {
        if (fileVertex.has(position)) continue;
        fileVertex.set(position, fileVertex.size);
        const decimals = edges.get(position)! < SHORT_EDGE ? FINE_DECIMALS : DECIMALS;
        const place = source.positions[position]!.map((value) => decimal(value, decimals));
        lines.push(`v ${place.join(' ')}`, `vt ${mainTexture.get(position)!}`);
      }
      const corners = newestFirst(face, fileVertex).map((corner) => {
        const back = fileVertex.get(corner.position)! - fileVertex.size;
        const text = textOf(corner);
        const isMain = text === mainTexture.get(corner.position);
        return `${back}/${isMain ? back : seams.get(text)! + 1}`;
      });
      lines.push(`f ${corners.join(' ')}`);
    }
  }
  return { text: `${lines.join('\n')}\n`, sourceVertex: [...fileVertex.keys()] };
}

/** For each vertex, the texture coordinate of most of its corners. */
function mainTextures(
  faces: readonly Face[],
  textOf: (corner: Corner) => string,
): Map<number, string> {
  const counts = new Map<number, Map<string, number>>();
  for (const corner of faces.flat()) {
    const ofVertex = counts.get(corner.position) ?? new Map<string, number>();
    counts.set(corner.position, ofVertex);
    ofVertex.set(textOf(corner), (ofVertex.get(textOf(corner)) ?? 0) + 1);
  }
  return new Map(
    Array.from(counts, ([vertex, ofVertex]) => {
      const [most] = [...ofVertex].sort(([, a], [, b]) => b - a);
      return [vertex, most![0]] as const;
    }),
  );
}

/** For each vertex, the length of its shortest edge, in meters. */
function shortestEdges(
  positions: readonly Vector3[],
  faces: readonly Face[],
): ReadonlyMap<number, number> {
  const shortest = new Map<number, number>();
  for (const face of faces) {
    for (const [index, { position: from }] of face.entries()) {
      const to = face[(index + 1) % face.length]!.position;
      const length = Math.hypot(...subtract(positions[from]!, positions[to]!));
      for (const end of [from, to]) {
        shortest.set(end, Math.min(shortest.get(end) ?? Infinity, length));
      }
    }
  }
  return shortest;
}

/** The face from its newest vertex on, so that faces side by side begin alike. */
function newestFirst(face: Face, fileVertex: ReadonlyMap<number, number>): Face {
  const ages = face.map(({ position }) => fileVertex.get(position)!);
  const newest = ages.indexOf(Math.max(...ages));
  return [...face.slice(newest), ...face.slice(0, newest)];
}
