import { readFileSync } from 'node:fs';
import { trianglesOf, type SourceBone, type SourceSkin } from './source-skin.ts';
import type { Vector2, Vector3 } from './vector.ts';

/** The subset of glTF 2.0 that a GLB with one mesh of one primitive and one skin needs. */
interface Gltf {
  readonly accessors: readonly {
    readonly bufferView: number;
    readonly byteOffset?: number;
    readonly componentType: number;
    readonly count: number;
    readonly type: string;
  }[];
  readonly bufferViews: readonly { readonly byteOffset?: number; readonly byteStride?: number }[];
  readonly meshes: readonly {
    readonly primitives: readonly {
      readonly attributes: Readonly<Record<string, number>>;
      readonly indices: number;
    }[];
  }[];
  readonly nodes: readonly { readonly name: string }[];
  readonly skins: readonly {
    readonly inverseBindMatrices: number;
    readonly joints: readonly number[];
  }[];
}

type ReadComponent = (data: DataView, at: number) => number;

const COMPONENTS = new Map<number, { readonly size: number; readonly read: ReadComponent }>([
  [5121, { size: 1, read: (data, at) => data.getUint8(at) }],
  [5123, { size: 2, read: (data, at) => data.getUint16(at, true) }],
  [5126, { size: 4, read: (data, at) => data.getFloat32(at, true) }],
]);

const ITEM_LENGTHS = new Map([
  ['SCALAR', 1],
  ['VEC2', 2],
  ['VEC3', 3],
  ['VEC4', 4],
  ['MAT4', 16],
]);

/** Returns one array of numbers for each item of an accessor. */
function readAccessor(gltf: Gltf, data: DataView, index: number | undefined): number[][] {
  const accessor = gltf.accessors[index ?? -1];
  const view = gltf.bufferViews[accessor?.bufferView ?? -1];
  const component = COMPONENTS.get(accessor?.componentType ?? 0);
  const length = ITEM_LENGTHS.get(accessor?.type ?? '');
  if (!accessor || !view || !component || !length) throw new Error('an accessor of another kind');
  const stride = view.byteStride ?? component.size * length;
  const start = (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0);
  return Array.from({ length: accessor.count }, (_, item) =>
    Array.from({ length }, (_, part) =>
      component.read(data, start + item * stride + part * component.size),
    ),
  );
}

/**
 * Returns the origin of the frame whose inverse is this column-major matrix (a rotation and a
 * translation).
 */
function originOfInverse(matrix: readonly number[]): Vector3 {
  const along = (axis: number): number =>
    -[0, 1, 2].reduce((sum, row) => sum + matrix[axis * 4 + row]! * matrix[12 + row]!, 0);
  return [along(0), along(1), along(2)];
}

const HEADER_BYTES = 12;
const CHUNK_HEADER_BYTES = 8;

/**
 * Reads the bind pose of a binary glTF; the transforms of its nodes are not used.
 *
 * @param name for its only part
 */
export function readGlb(path: string, name: string): SourceSkin {
  const file = readFileSync(path);
  const jsonLength = file.readUInt32LE(HEADER_BYTES);
  const jsonStart = HEADER_BYTES + CHUNK_HEADER_BYTES;
  const binaryStart = jsonStart + jsonLength + CHUNK_HEADER_BYTES;
  const json = file.toString('utf8', jsonStart, jsonStart + jsonLength);
  const gltf = JSON.parse(json) as Gltf;
  const data = new DataView(file.buffer, file.byteOffset + binaryStart);
  const read = (index: number | undefined): number[][] => readAccessor(gltf, data, index);

  const primitive = gltf.meshes[0]?.primitives[0];
  const skin = gltf.skins[0];
  if (!primitive || !skin) throw new Error(`${path} has no skinned mesh`);
  const { POSITION, TEXCOORD_0, JOINTS_0, WEIGHTS_0 } = primitive.attributes;

  const columns = skin.joints.map(() => new Map<number, number>());
  const weights = read(WEIGHTS_0);
  read(JOINTS_0).forEach((slots, vertex) => {
    slots.forEach((joint, slot) => {
      const weight = weights[vertex]![slot]!;
      if (weight > 0) columns[joint]!.set(vertex, weight);
    });
  });
  const inverseBinds = read(skin.inverseBindMatrices);
  const bones = skin.joints.map((node, joint): [string, SourceBone] => [
    gltf.nodes[node]!.name,
    { position: originOfInverse(inverseBinds[joint]!), weights: columns[joint]! },
  ]);
  return {
    positions: read(POSITION).map(([x, y, z]): Vector3 => [x!, y!, z!]),
    textureCoordinates: read(TEXCOORD_0).map(([u, v]): Vector2 => [u!, 1 - v!]),
    parts: [{ name, triangles: trianglesOf(read(primitive.indices).flat()) }],
    bones: new Map(bones),
  };
}
