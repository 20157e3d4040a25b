import type {
  CharacterParts,
  DofParts,
  JointParts,
  MeshParts,
  MorphParts,
} from '../core/character-parts.ts';
import type { Character } from '../core/character.ts';
import type { Morph } from '../core/morph.ts';
import { noParent } from '../core/skeleton.ts';
import { type Influence, influencesOf, noJoint } from '../core/skin.ts';
import { strongestInfluences } from '../core/strongest-influences.ts';
import { quaternionOf } from './ball-values.ts';
import { ballDof, ballHinges, rootSlides } from './cse169/joint-dofs.ts';
import { uniqueNames } from './unique-names.ts';
import { bindMatrix } from './cse169/write-skin.ts';
import { jointNames } from './mit/joint-names.ts';
import type { FormatShape } from './format.ts';
import type { Target } from './solve-pose.ts';
import { writtenNames } from './written-names.ts';

/**
 * Returns loose parts in the shape of the other format. A point of the new mesh is a render vertex
 * of the old one.
 *
 * @param restAngles (jointCount × 3) the file's pose, if the format has one
 */
export function convertParts(
  { name, skeleton, mesh, skin, materials, morphs, missing }: Character,
  shape: FormatShape,
  { product, turnsByBall, frames, insertRoot, bound }: Target,
  restAngles: Float64Array | null,
): CharacterParts {
  const shift = insertRoot ? 1 : 0;
  const parents = Array.from(skeleton.jointOfSource, (joint) => {
    const parent = skeleton.parents[joint]!;
    return parent === noParent
      ? insertRoot
        ? 0
        : noParent
      : skeleton.sourceIndex[parent]! + shift;
  });
  const allParents = insertRoot ? [noParent, ...parents] : parents;
  // Names as the files will give them, so that a pose refers to the right joints.
  const ownNames = Array.from(skeleton.jointOfSource, (joint) => skeleton.names[joint]!);
  const names = shape.jointNames
    ? uniqueNames(writtenNames(ownNames, shape.jointNames))
    : jointNames(allParents);
  const joints: JointParts[] = Array.from(skeleton.jointOfSource, (joint, source) => {
    const parent = parents[source]!;
    const dofs = turns(restAngles ? tripleAt(restAngles, joint) : [0, 0, 0]);
    return {
      name: names[source + shift]!,
      ...(shape.jointNames ? { fileName: names[source]! } : {}),
      parent,
      restOffset: frames === 'bind' ? offsetAtBind(joint) : tripleAt(skeleton.restOffsets, joint),
      dofs: parent === noParent ? [...rootSlides, ...dofs] : dofs,
    };
  });
  if (insertRoot) {
    const dofs = [...rootSlides, ...turns([0, 0, 0])];
    joints.unshift({ name: names[0]!, parent: noParent, restOffset: [0, 0, 0], dofs });
  }
  return {
    name,
    skeleton: { file: `${name}.skel`, joints },
    ...(mesh.pointCount > 0 ? { mesh: meshParts() } : {}),
    ...(skin.paletteJoint.includes(noJoint) ? {} : { skin: skinParts() }),
    ...(shape.morphs ? { morphs: morphs.map(morphParts) } : {}),
    missing,
  };

  function turns(angles: [number, number, number]): DofParts[] {
    if (turnsByBall) return [{ ...ballDof, rest: quaternionOf(angles) }];
    const outermostZ = ballHinges(angles, []);
    return product === 'zyx' ? outermostZ : outermostZ.toReversed();
  }

  function offsetAtBind(joint: number): [number, number, number] {
    const parent = skeleton.parents[joint]!;
    const place = tripleAt(bound, joint);
    if (parent === noParent) return place;
    const from = tripleAt(bound, parent);
    return [place[0] - from[0], place[1] - from[1], place[2] - from[2]];
  }

  function meshParts(): MeshParts {
    const corners = Int32Array.from(mesh.indices);
    return {
      file: `${name}.obj`,
      positions: mesh.positions,
      cornerPoints: mesh.indices,
      normals: mesh.normals,
      cornerNormals: corners,
      ...(mesh.uvs ? { uvs: mesh.uvs, cornerUvs: corners } : {}),
      materials,
      submeshes: mesh.submeshes.map(({ material, firstIndex }) => {
        return { material, firstTriangle: firstIndex / 3 };
      }),
    };
  }

  function skinParts() {
    const start = new Uint32Array(mesh.vertexCount + 1);
    const influences: Influence[] = [];
    mesh.pointOf.forEach((point, vertex) => {
      influences.push(...strongestInfluences(influencesOf(skin, point), shape.influences));
      start[vertex + 1] = influences.length;
    });
    const binds = {
      jointFromBind: new Float64Array(skeleton.jointCount * 16),
      bindFromJoint: new Float64Array(skeleton.jointCount * 16),
    };
    skeleton.sourceIndex.forEach((source, joint) => {
      const entry = skin.paletteJoint.indexOf(joint);
      const inverse = skin.jointFromBind.subarray(entry * 16, entry * 16 + 16);
      binds.jointFromBind.set(inverse, source * 16);
      binds.bindFromJoint.set(bindMatrix(skin, entry), source * 16);
    });
    return {
      file: `${name}.attach`,
      start,
      joints: Uint16Array.from(influences, ({ entry }) => {
        return skeleton.sourceIndex[skin.paletteJoint[entry]!]! + shift;
      }),
      weights: Float32Array.from(influences, ({ weight }) => weight),
      normals: shape.normals,
      ...(shape.bindings ? binds : {}),
    };
  }
}

/** The same morph with the render vertices as points. */
function morphParts({
  parts,
  vertices,
  offsets,
  normalVertices,
  normalOffsets,
}: Morph): MorphParts {
  return { ...parts, points: vertices, offsets, normalPoints: normalVertices, normalOffsets };
}

export function tripleAt(values: Float64Array, index: number): [number, number, number] {
  return [values[index * 3]!, values[index * 3 + 1]!, values[index * 3 + 2]!];
}
