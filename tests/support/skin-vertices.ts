import { jointMatrices } from '../../src/core/forward-kinematics.ts';
import type { Character } from '../../src/core/character.ts';
import type { Pose } from '../../src/core/pose.ts';
import type { Skin } from '../../src/core/skin.ts';
import { poseVertices } from '../../src/skinning/pose-vertices.ts';
import { restMesh } from '../../src/skinning/rest-mesh.ts';
import { useOf } from './method-use.ts';
import type { SkinningMethod, VertexStreams } from '../../src/skinning/method.ts';

/**
 * Skins on the CPU from start to end: pose → matrices → palette → vertices, with morphs before. It
 * is separate from the evaluation, which tests compare with it.
 */
export function skinVertices(
  character: Character,
  skin: Skin,
  pose: Pose,
  method: SkinningMethod,
): VertexStreams {
  const { skeleton } = character;
  const mesh = restMesh(character, pose);
  const palette = new Float32Array(skin.paletteJoint.length * method.vec4sPerEntry(skin) * 4);
  method.packPalette(skin, jointMatrices(skeleton, pose.q), palette);
  const out = {
    positions: new Float32Array(mesh.vertexCount * 3),
    normals: new Float32Array(mesh.vertexCount * 3),
  };
  const use = useOf(method, character.mesh, skin);
  poseVertices(method, character.mesh, mesh, skin, palette, use, out);
  return out;
}
