import { join } from 'node:path';
import { mat4, quat, vec3 } from 'gl-matrix';
import { childOf, matrixAt, nodesOf, numbersOf, readEgg, type EggNode } from './egg-source.ts';
import type { Vector2, Vector3 } from './vector.ts';

/** The panda in file space: meters (it is 1.1 long), +y up, facing +z. */
export interface PandaSource {
  readonly positions: readonly Vector3[];
  readonly normals: readonly Vector3[];
  readonly textureCoordinates: readonly Vector2[];
  readonly triangles: readonly (readonly number[])[];
  /** For each vertex, the weights of bones by name. */
  readonly weights: readonly ReadonlyMap<string, number>[];
  /** The place of each bone while the mesh is bound. */
  readonly bones: ReadonlyMap<string, Vector3>;
  /** For each frame of the walk, where each bone is and how it has turned since the binding. */
  readonly frames: readonly ReadonlyMap<string, BoneMotion>[];
}

export interface BoneMotion {
  readonly place: Vector3;
  readonly turn: quat;
}

export const FRAMES_PER_SECOND = 30;
const METERS_PER_UNIT = 0.001;

/** The source has +z up and faces -y. */
const toFileSpace = ([x = 0, y = 0, z = 0]: ArrayLike<number> & Iterable<number>): Vector3 => [
  x * METERS_PER_UNIT,
  z * METERS_PER_UNIT,
  -y * METERS_PER_UNIT,
];

/** Reads `panda-model.egg.pz` and `panda-walk4.egg.pz` in the folder `models` of Panda3D. */
export function readPanda(folder: string): PandaSource {
  const model = readEgg(join(folder, 'panda-model.egg.pz'));
  const corners = nodesOf(model, 'Polygon').map((polygon) =>
    numbersOf(childOf(polygon, 'VertexRef')),
  );
  // One vertex belongs to no triangle, and has no weights.
  const used = new Set(corners.flat());
  const vertices = nodesOf(model, 'Vertex').filter(({ name }) => used.has(Number(name)));
  const indexOf = new Map(vertices.map(({ name }, index) => [Number(name), index]));
  const weights = vertices.map(() => new Map<string, number>());
  for (const joint of nodesOf(model, 'Joint')) {
    for (const member of joint.children.filter(({ type }) => type === 'VertexRef')) {
      const [weight = 1] = numbersOf(childOf(member, 'Scalar', 'membership'));
      for (const vertex of numbersOf(member)) {
        const index = indexOf.get(vertex);
        if (index !== undefined) weights[index]!.set(joint.name, weight);
      }
    }
  }
  const bound = bindMatrices(model);
  return {
    positions: vertices.map((vertex) => toFileSpace(numbersOf(vertex))),
    normals: vertices.map((vertex) => {
      const [x, y, z] = toFileSpace(numbersOf(childOf(vertex, 'Normal')));
      const length = Math.hypot(x, y, z);
      return [x / length, y / length, z / length];
    }),
    textureCoordinates: vertices.map((vertex) => {
      const [u = 0, v = 0] = numbersOf(childOf(vertex, 'UV'));
      return [u, v];
    }),
    triangles: corners.map((triangle) => triangle.map((vertex) => indexOf.get(vertex)!)),
    weights,
    bones: new Map(Array.from(bound, ([name, matrix]) => [name, placeOf(matrix)])),
    frames: readFrames(join(folder, 'panda-walk4.egg.pz'), bound),
  };
}

/** From each bone's frame to the source's space, while the mesh is bound. */
function bindMatrices(model: EggNode): ReadonlyMap<string, mat4> {
  return worldMatrices(model, 'Joint', (joint) => {
    const transform = childOf(joint, 'Transform')!;
    return Float64Array.from(numbersOf(childOf(transform, 'Matrix4')));
  });
}

function readFrames(
  path: string,
  bound: ReadonlyMap<string, mat4>,
): ReadonlyMap<string, BoneMotion>[] {
  const [skeleton] = nodesOf(readEgg(path), 'Table').filter(({ name }) => name === '<skeleton>');
  const counts = nodesOf(skeleton!, 'V').map(({ words }) => words.length);
  return Array.from({ length: Math.max(...counts) }, (_, frame) => {
    const worlds = worldMatrices(skeleton!, 'Table', (table) => matrixAt(table, frame));
    return new Map(
      Array.from(worlds, ([name, world]) => [
        name,
        { place: placeOf(world), turn: turnBetween(bound.get(name)!, world) },
      ]),
    );
  });
}

function worldMatrices(
  node: EggNode,
  type: string,
  localOf: (node: EggNode) => mat4,
): Map<string, mat4> {
  const worlds = new Map<string, mat4>();
  const visit = (parent: EggNode, worldOfParent: mat4): void => {
    for (const child of parent.children) {
      const isBone = child.type === type;
      const world: mat4 = new Float64Array(worldOfParent);
      if (isBone) mat4.multiply(world, worldOfParent, localOf(child));
      if (isBone) worlds.set(child.name, world);
      visit(child, world);
    }
  };
  visit(node, mat4.identity(new Float64Array(16)));
  return worlds;
}

function placeOf(matrix: mat4): Vector3 {
  return toFileSpace(mat4.getTranslation(vec3.create(), matrix));
}

/** The rotation from one matrix to another, in file space; the scale of a bone never changes. */
function turnBetween(from: mat4, to: mat4): quat {
  const motion: mat4 = new Float64Array(16);
  mat4.multiply(motion, to, mat4.invert(new Float64Array(16), from)!);
  const [x, y, z, w] = mat4.getRotation(new Float64Array(4), motion);
  return quat.normalize(new Float64Array(4), [x!, z!, -y!, w!]);
}
