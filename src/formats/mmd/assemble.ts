import type {
  CharacterParts,
  DofParts,
  JointParts,
  MeshParts,
  SkinParts,
} from '../../core/character-parts.ts';
import type { DiagnosticLog } from '../../core/diagnostics.ts';
import { MmdBoneType } from './mmd-parts.ts';
import { DofKind, noParent } from '../../core/skeleton.ts';
import { rootSlides } from '../cse169/joint-dofs.ts';
import { uniqueNames } from '../unique-names.ts';
import type { PmdBone } from './bones.ts';
import type { PmdMaterials } from './materials.ts';
import { type PmdVertices, vertexSize } from './vertices.ts';

const ball: DofParts = { kind: DofKind.ball, axis: [0, 0, 0] };

/** Makes a joint of every bone of the file, including all roots, in the order of the file. */
export function skeletonParts(
  file: string,
  bones: readonly PmdBone[],
): NonNullable<CharacterParts['skeleton']> {
  const names = uniqueNames(
    bones.map(({ name }) => name),
    'bone',
  );
  const joints = bones.map(({ name, parent, parentOffset, type, head }, index): JointParts => {
    const from = bones[parent]?.head ?? [0, 0, 0];
    const isMovable =
      parent === noParent || type === MmdBoneType.rotateAndMove || type === MmdBoneType.ik;
    return {
      name: names[index]!,
      fileName: name,
      place: { offset: parentOffset },
      parent,
      restOffset: [head[0] - from[0], head[1] - from[1], head[2] - from[2]],
      dofs: isMovable ? [...rootSlides, ball] : [ball],
    };
  });
  return { file, joints };
}

/** The mesh has one normal and one texture coordinate per point. */
export function meshParts(
  file: string,
  { positions, normals, uvs }: PmdVertices,
  cornerPoints: Uint32Array,
  { materials, submeshes }: PmdMaterials,
): MeshParts {
  const corners = Int32Array.from(cornerPoints);
  return {
    file,
    positions,
    cornerPoints,
    normals,
    cornerNormals: corners,
    // The file counts v from the image's upper edge, Sinew from the lower one.
    uvs: uvs.map((value, i) => (i % 2 === 1 ? 1 - value : value)),
    cornerUvs: corners,
    materials,
    submeshes,
  };
}

/**
 * Each vertex has up to two bones; those without weight are left out. A bone that does not exist is
 * an error.
 */
export function skinParts(
  file: string,
  vertices: PmdVertices,
  boneCount: number,
  log: DiagnosticLog,
  effect: string,
): SkinParts {
  const start = new Uint32Array(vertices.count + 1);
  const joints: number[] = [];
  const weights: number[] = [];
  for (let vertex = 0; vertex < vertices.count; vertex++) {
    const [first, second] = vertices.bones.subarray(vertex * 2, vertex * 2 + 2);
    const weight = vertices.weights[vertex]! / 100;
    if (first === second) add(vertex, 0, 1);
    else {
      add(vertex, 0, weight);
      add(vertex, 1, 1 - weight);
    }
    start[vertex + 1] = joints.length;
  }
  return {
    file,
    start,
    joints: Uint16Array.from(joints),
    weights: Float32Array.from(weights),
  };

  function add(vertex: number, which: 0 | 1, weight: number): void {
    if (weight === 0) return;
    const bone = vertices.bones[vertex * 2 + which]!;
    if (bone >= boneCount) {
      log.error({
        code: 'pmd/index',
        offset: vertices.offset + vertex * vertexSize + 32 + which * 2,
        expected: `bones from 0 to ${boneCount - 1}`,
        found: `${bone}, vertex ${vertex}`,
        effect,
      });
    }
    joints.push(bone);
    weights.push(weight);
  }
}
