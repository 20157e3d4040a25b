import type {
  CharacterParts,
  JointParts,
  MeshParts,
  SkinParts,
} from '../../core/character-parts.ts';
import type { DiagnosticLog } from '../../core/diagnostics.ts';
import { MmdBoneType } from './mmd-parts.ts';
import { noParent } from '../../core/skeleton.ts';
import { ballDof, rootSlides } from '../cse169/joint-dofs.ts';
import { uniqueNames } from '../unique-names.ts';
import type { PmdBone } from './bones.ts';
import type { PmdMaterials } from './materials.ts';
import { type PmdVertices, vertexSize } from './vertices.ts';

/** Makes a joint of every bone of the file, including all roots, in the order of the file. */
export function skeletonParts(
  file: string,
  bones: readonly PmdBone[],
  englishNames: readonly string[] = [],
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
      ...englishNameOf(name, englishNames[index]),
      place: { offset: parentOffset },
      parent,
      restOffset: [head[0] - from[0], head[1] - from[1], head[2] - from[2]],
      dofs: isMovable ? [...rootSlides, ballDof] : [ballDof],
    };
  });
  return { file, joints };
}

/** A name in English that says the same as the other is none. */
function englishNameOf(name: string, english = ''): Pick<JointParts, 'englishName'> {
  return english === '' || english === name ? {} : { englishName: english };
}

/** The mesh has one normal and one texture coordinate per point. */
export function meshParts(
  file: string,
  { positions, normals, uvs }: PmdVertices,
  cornerPoints: Uint32Array,
  { materials, submeshes }: PmdMaterials,
): MeshParts {
  // The same bytes, which are indices below 2^31: normals and uvs are those of the points.
  const corners = new Int32Array(cornerPoints.buffer);
  return {
    file,
    positions,
    cornerPoints,
    normals,
    cornerNormals: corners,
    uvs: turnedOver(uvs),
    cornerUvs: corners,
    materials,
    submeshes,
  };
}

/** The file counts v from the image's upper edge, Sinew from the lower one. */
function turnedOver(uvs: Float32Array): Float32Array {
  const turned = uvs.slice();
  for (let i = 1; i < turned.length; i += 2) turned[i] = 1 - turned[i]!;
  return turned;
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
  const { count, bones } = vertices;
  const start = new Uint32Array(count + 1);
  const joints = new Uint16Array(count * 2);
  const weights = new Float32Array(count * 2);
  let filled = 0;
  for (let vertex = 0; vertex < count; vertex++) {
    const weight = vertices.weights[vertex]! / 100;
    if (bones[vertex * 2] === bones[vertex * 2 + 1]) add(vertex, 0, 1);
    else {
      add(vertex, 0, weight);
      add(vertex, 1, 1 - weight);
    }
    start[vertex + 1] = filled;
  }
  return { file, start, joints: joints.slice(0, filled), weights: weights.slice(0, filled) };

  function add(vertex: number, which: 0 | 1, weight: number): void {
    if (weight === 0) return;
    const bone = bones[vertex * 2 + which]!;
    if (bone >= boneCount) {
      log.error({
        code: 'pmd/index',
        offset: vertices.offset + vertex * vertexSize + 32 + which * 2,
        expected: `bones from 0 to ${boneCount - 1}`,
        found: `${bone}, vertex ${vertex}`,
        effect,
      });
    }
    joints[filled] = bone;
    weights[filled++] = weight;
  }
}
