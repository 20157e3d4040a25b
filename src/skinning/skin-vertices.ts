import { worldMatrices } from '../core/forward-kinematics.ts';
import type { Character } from '../core/character.ts';
import type { Pose } from '../core/pose.ts';
import type { Skin } from '../core/skin.ts';
import { restMesh } from './rest-mesh.ts';
import type { SkinningMethod, VertexStreams } from './method.ts';

/** The whole way on the CPU: pose → matrices → palette → vertices, morphs before. For tools, tests and export. */
export function skinVertices(
  character: Character,
  skin: Skin,
  pose: Pose,
  method: SkinningMethod,
): VertexStreams {
  const { skeleton } = character;
  const mesh = restMesh(character, pose);
  const palette = new Float32Array(skin.paletteJoint.length * method.vec4sPerEntry * 4);
  method.packPalette(skin, worldMatrices(skeleton, pose.q), palette);
  const out = {
    positions: new Float32Array(mesh.vertexCount * 3),
    normals: new Float32Array(mesh.vertexCount * 3),
  };
  method.deform(mesh, skin, palette, out);
  return out;
}
