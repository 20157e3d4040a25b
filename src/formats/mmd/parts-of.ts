import type { Character } from '../../core/character.ts';
import { jointMatrices } from '../../core/forward-kinematics.ts';
import type { Mesh } from '../../core/mesh.ts';
import { DofKind, noParent, type Skeleton } from '../../core/skeleton.ts';
import type { BonePairs } from './bone-pairs.ts';
import {
  MmdBoneType,
  mmdOf,
  type MmdBone,
  type MmdMorphs,
  type MmdParts,
  type Numbers3,
} from './mmd-parts.ts';

/** The MMD data of a character that comes from a PMD, if they belong to all of its parts. */
export function ownParts(character: Character): MmdParts | undefined {
  const mmd = mmdOf(character);
  const { skeleton, mesh } = character;
  const isWhole =
    mmd?.bones.length === skeleton.jointCount && mmd.vertices.weights.length === mesh.vertexCount;
  return isWhole ? mmd : undefined;
}

const namesOfToons = Array.from({ length: 10 }, (_, index) => {
  return `toon${String(index + 1).padStart(2, '0')}.bmp`;
});

/** At most this many morphs can be listed. */
const listedMorphs = 255;

/** Panels of morphs, as the file numbers them. */
const [basePanel, otherPanel] = [0, 4];

/** The MMD data of a character from another format, with the names of the usual toon ramps. */
export function partsOf(character: Character, { bones, weights }: BonePairs): MmdParts {
  const { name, skeleton, mesh } = character;
  const morphs = morphsOf(character);
  return {
    kind: 'mmd',
    summary: 'nothing of its own',
    version: 1,
    modelName: name,
    comment: '',
    bones: bonesOf(skeleton),
    vertices: {
      normals: mesh.normals,
      uvs: turnedOver(mesh),
      bones,
      weights,
      edgeFlags: new Uint8Array(mesh.vertexCount),
    },
    ikChains: [],
    morphs,
    display: {
      morphs: morphs.listed.map((_, index) => index).slice(1, 1 + listedMorphs),
      groupNames: skeleton.jointCount > 1 ? ['bones\n'] : [],
      // A program lists the first bone by itself.
      bones: Array.from(skeleton.jointOfSource.subarray(1), (_, index) => {
        return { bone: index + 1, group: 1 };
      }),
    },
    toons: namesOfToons,
  };
}

function bonesOf(skeleton: Skeleton): MmdBone[] {
  const { jointOfSource, parents, dofStart, dofKind } = skeleton;
  const characterFromJoint = jointMatrices(skeleton, skeleton.qRest);
  const firstChild = new Map<number, number>();
  jointOfSource.forEach((joint, source) => {
    const parent = parents[joint]!;
    if (parent !== noParent && !firstChild.has(parent)) firstChild.set(parent, source);
  });
  return Array.from(jointOfSource, (joint): MmdBone => {
    const dof = dofStart[joint]!;
    const isMovable = dof < dofStart[joint + 1]! && dofKind[dof] === DofKind.slide;
    const tail = firstChild.get(joint) ?? -1;
    return {
      type: isMovable ? MmdBoneType.rotateAndMove : MmdBoneType.rotate,
      // Bone 0 can't be a tail, because 0 stands for none.
      tail: tail > 0 ? tail : -1,
      ikParent: 0,
      head: placeOf(joint),
    };
  });

  function placeOf(joint: number): Numbers3 {
    const place = (axis: number): number =>
      Math.fround(characterFromJoint[joint * 16 + 12 + axis]!);
    return [place(0), place(1), place(2)];
  }
}

/** The file counts v from the image's upper edge, Sinew from the lower one. */
function turnedOver({ uvs, vertexCount }: Mesh): Float32Array {
  if (!uvs) return new Float32Array(vertexCount * 2);
  return uvs.map((value, i) => (i % 2 === 1 ? 1 - value : value));
}

/** The base has all vertices that any morph moves. */
function morphsOf({ mesh, morphs }: Character): MmdMorphs {
  const basePoints = Uint32Array.from(
    new Set(morphs.flatMap(({ vertices }) => [...vertices])),
  ).sort();
  const basePositions = new Float32Array(basePoints.length * 3);
  basePoints.forEach((vertex, index) => {
    basePositions.set(mesh.positions.subarray(vertex * 3, vertex * 3 + 3), index * 3);
  });
  const base = { fileName: 'base', panel: basePanel, morph: -1 };
  const others = morphs.map(({ name }, morph) => ({ fileName: name, panel: otherPanel, morph }));
  return { basePoints, basePositions, listed: others.length > 0 ? [base, ...others] : [] };
}
