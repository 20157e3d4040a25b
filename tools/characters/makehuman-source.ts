import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gunzipSync } from 'node:zlib';
import type { Corner, Face } from './pack-mesh.ts';
import { meanOf, type Vector2, type Vector3 } from './vector.ts';

/** The base mesh in its own units (decimeters), +y up, facing +z, with the faces by group name. */
export interface BaseMesh {
  readonly positions: Vector3[];
  readonly textureCoordinates: Vector2[];
  readonly groups: ReadonlyMap<string, Face[]>;
}

/** A rig puts the head of a bone at the mean of a helper cube's vertices, or of listed vertices. */
interface RigEnd {
  readonly strategy: string;
  readonly cube_name?: string;
  readonly vertex_indices?: readonly number[];
}

interface RigBone {
  readonly head: RigEnd;
  readonly parent: string;
}

export type Rig = Readonly<Record<string, RigBone>>;

/** For each bone, the pairs (vertex of the base mesh, weight). */
export type RigWeights = Readonly<Record<string, readonly (readonly [number, number])[]>>;

function itemAt<Item>(items: readonly Item[], index: number, what: string): Item {
  const item = items[index];
  if (item === undefined) throw new Error(`${what} has no item ${index}`);
  return item;
}

function numbersOf(fields: readonly string[], count: number, line: string): number[] {
  const numbers = fields.slice(1, 1 + count).map(Number);
  if (numbers.length < count || numbers.some(Number.isNaN)) throw new Error(`bad line: ${line}`);
  return numbers;
}

function parseCorner(text: string): Corner {
  const [position, texture] = text.split('/').map(Number);
  if (!position || !texture) throw new Error(`a corner without texture coordinate: ${text}`);
  return { position: position - 1, texture: texture - 1 };
}

/** Reads every group of `3dobjs/base.obj`, including helpers and joint cubes. */
export function readBaseMesh(folder: string): BaseMesh {
  const positions: Vector3[] = [];
  const textureCoordinates: Vector2[] = [];
  const groups = new Map<string, Face[]>();
  let group = '';
  for (const line of readFileSync(join(folder, '3dobjs/base.obj'), 'utf8').split('\n')) {
    const fields = line.trim().split(/\s+/);
    if (fields[0] === 'v') {
      const [x = 0, y = 0, z = 0] = numbersOf(fields, 3, line);
      positions.push([x, y, z]);
    } else if (fields[0] === 'vt') {
      const [u = 0, v = 0] = numbersOf(fields, 2, line);
      textureCoordinates.push([u, v]);
    } else if (fields[0] === 'g') {
      group = fields[1] ?? '';
    } else if (fields[0] === 'f') {
      const faces = groups.get(group) ?? [];
      faces.push(fields.slice(1).map(parseCorner));
      groups.set(group, faces);
    }
  }
  return { positions, textureCoordinates, groups };
}

/** Adds `weight` times a morph target (offsets in decimeters) to the positions, in place. */
export function addTarget(
  folder: string,
  name: string,
  weight: number,
  positions: Vector3[],
): void {
  const packed = readFileSync(join(folder, 'targets', `${name}.target.gz`));
  for (const line of gunzipSync(packed).toString('utf8').split('\n')) {
    if (line.trim() === '' || line.startsWith('#')) continue;
    const [index = -1, x = 0, y = 0, z = 0] = line.trim().split(/\s+/).map(Number);
    const old = itemAt(positions, index, 'the base mesh');
    positions[index] = [old[0] + weight * x, old[1] + weight * y, old[2] + weight * z];
  }
}

export function readRig(folder: string): Rig {
  return JSON.parse(readFileSync(join(folder, 'rigs/standard/rig.cmu_mb.json'), 'utf8')) as Rig;
}

export function readRigWeights(folder: string): RigWeights {
  const path = join(folder, 'rigs/standard/weights.cmu_mb.json');
  const file = JSON.parse(readFileSync(path, 'utf8')) as { readonly weights: RigWeights };
  return file.weights;
}

/** Returns the start of a bone on this (already morphed) mesh, in the mesh's units and space. */
export function boneHead(rig: Rig, bone: string, mesh: BaseMesh): Vector3 {
  const head = rig[bone]?.head;
  if (head === undefined) throw new Error(`the rig has no bone ${bone}`);
  if (head.strategy === 'MEAN' && head.vertex_indices !== undefined) {
    return meanOf(head.vertex_indices.map((index) => itemAt(mesh.positions, index, 'the mesh')));
  }
  const cube = mesh.groups.get(head.cube_name ?? '');
  if (head.strategy !== 'CUBE' || cube === undefined) throw new Error(`no place for bone ${bone}`);
  const corners = new Set(cube.flat().map((corner) => corner.position));
  return meanOf([...corners].map((index) => itemAt(mesh.positions, index, 'the mesh')));
}

/** For each vertex of the base mesh, returns its mirror image in the plane x = 0, or itself. */
export function readMirror(folder: string): number[] {
  const mirror: number[] = [];
  const text = readFileSync(join(folder, 'mesh_metadata/hm08.mirror'), 'utf8');
  for (const line of text.split('\n')) {
    const [vertex, other] = line.trim().split(/\s+/).map(Number);
    if (vertex !== undefined && other !== undefined) mirror[vertex] = other;
  }
  return mirror;
}
