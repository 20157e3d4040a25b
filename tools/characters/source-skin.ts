import { readJointTable } from './joint-table.ts';
import type { Material } from './mit-text.ts';
import type { Face } from './pack-mesh.ts';
import type { Vector2, Vector3 } from './vector.ts';
import { writeCharacter } from './write-character.ts';

export interface SourceBone {
  /** The center of rotation in the pose in which the mesh is stored. */
  readonly position: Vector3;
  /** From vertex to weight. */
  readonly weights: ReadonlyMap<number, number>;
}

export interface SourcePart {
  readonly name: string;
  readonly triangles: readonly (readonly number[])[];
}

/** A skinned mesh as engines store it: vertices are duplicated along texture seams. */
export interface SourceSkin {
  readonly positions: readonly Vector3[];
  /** One per position, with the origin at the lower left. */
  readonly textureCoordinates: readonly Vector2[];
  readonly parts: readonly SourcePart[];
  readonly bones: ReadonlyMap<string, SourceBone>;
}

export function boneOf(skin: SourceSkin, name: string): SourceBone {
  const bone = skin.bones.get(name);
  if (bone === undefined) throw new Error(`the source has no bone ${name}`);
  return bone;
}

/** Adds a part that moves with one bone and has no texture. */
export function addRigidPart(
  skin: SourceSkin,
  name: string,
  boneName: string,
  corners: readonly Vector3[],
): SourceSkin {
  const start = skin.positions.length;
  const vertices = corners.map((_, corner) => start + corner);
  const bone = boneOf(skin, boneName);
  const weights = new Map([...bone.weights, ...vertices.map((vertex) => [vertex, 1] as const)]);
  return {
    positions: [...skin.positions, ...corners],
    textureCoordinates: [...skin.textureCoordinates, ...corners.map((): Vector2 => [0, 0])],
    parts: [...skin.parts, { name, triangles: trianglesOf(vertices) }],
    bones: new Map(skin.bones).set(boneName, { ...bone, weights }),
  };
}

/** Groups the vertices into triangles, three in a row for each. */
export function trianglesOf(vertices: readonly number[]): number[][] {
  return Array.from({ length: vertices.length / 3 }, (_, face) =>
    vertices.slice(face * 3, face * 3 + 3),
  );
}

/** The smallest y of the turned mesh. */
export function floorOf(skin: SourceSkin, turn: (point: Vector3) => Vector3): number {
  return skin.positions.reduce((low, point) => Math.min(low, turn(point)[1]), Infinity);
}

/**
 * The mesh with one vertex per position, so that duplicates do not separate where the mesh bends.
 */
interface Welded {
  readonly positions: readonly Vector3[];
  /** The first vertex of the source at each position. */
  readonly first: readonly number[];
  /** Maps the source's vertices to positions. */
  readonly placeOf: readonly number[];
}

function weld(points: readonly Vector3[]): Welded {
  const places = new Map<string, number>();
  const first: number[] = [];
  const placeOf = points.map((point, vertex) => {
    const key = point.join(' ');
    const place = places.get(key) ?? first.push(vertex) - 1;
    places.set(key, place);
    return place;
  });
  return { positions: first.map((vertex) => points[vertex]!), first, placeOf };
}

/** For each point, the index of its mirror image in the plane x = 0, or its own. */
function mirrorOf(points: readonly Vector3[]): number[] {
  // Six decimals are used because rounding moved the two sides apart by less than that.
  const key = (x: number, y: number, z: number): string =>
    [x, y, z].map((value) => Math.round(value * 1e6)).join(' ');
  const indices = new Map(points.map(([x, y, z], index) => [key(x, y, z), index]));
  return points.map(([x, y, z], index) => indices.get(key(-x, y, z)) ?? index);
}

/**
 * Writes the three files of a character from an engine's skin. Its root has no weights and is at
 * the position of joint 1, because an `.attach` file has no column for joint 0.
 *
 * @param place maps a point of the source to file space
 */
export function makeFromSkin(
  name: string,
  skin: SourceSkin,
  place: (point: Vector3) => Vector3,
  dataFolder: string,
  materials?: readonly Material[],
): void {
  const { parents, bones } = readJointTable(name);
  const { positions, first, placeOf } = weld(skin.positions.map(place));
  const parts = skin.parts.map((part) => ({
    name: part.name,
    faces: part.triangles.map((corners): Face =>
      corners.map((vertex) => ({ position: placeOf[vertex]!, texture: vertex })),
    ),
  }));
  const columns = bones.slice(1).map((bone) => boneOf(skin, bone).weights);
  const joints = bones.map((bone) => place(boneOf(skin, bone === '' ? bones[1]! : bone).position));
  const { textureCoordinates } = skin;
  writeCharacter(dataFolder, name, {
    ...{ joints, parents, ...(materials ? { materials } : {}) },
    mesh: { positions, textureCoordinates, parts, mirror: mirrorOf(positions) },
    weightsOf: (vertex) => columns.map((column) => column.get(first[vertex]!) ?? 0),
  });
}
