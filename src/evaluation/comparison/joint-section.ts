import { mat4, vec3 } from 'gl-matrix';
import { bonesOf } from '../../core/bones.ts';
import type { Character } from '../../core/character.ts';
import { jointMatrices } from '../../core/forward-kinematics.ts';
import { cutOutlines, type Outline, outlineAround } from './outline.ts';

/**
 * Returns the outline of the skin around a joint: the cut of the mesh in its bind pose by the plane
 * through the joint, perpendicular to the longest bone that starts there. Null if the joint has no
 * bone or is not inside the mesh.
 */
export function jointSection(character: Character, joint: number): Outline | null {
  const { mesh } = character;
  const bones = bonesOf(character).filter((bone) => bone.joint === joint);
  const lengths = bones.map(({ vector }) => Math.hypot(...vector));
  const bone = bones[lengths.indexOf(Math.max(...lengths))];
  if (!bone || mesh.pointCount === 0) return null;
  const characterFromJoint = bindOf(character, joint);
  const [x, y, z] = Array.from(characterFromJoint).slice(12);
  const origin: [number, number, number] = [x!, y!, z!];
  const end: [number, number, number] = [...bone.vector];
  vec3.transformMat4(end, end, characterFromJoint);
  vec3.subtract(end, end, origin);
  const outlines = cutOutlines(mesh, origin, end);
  return outlineAround(outlines, mesh.positions, origin, end);
}

/** From the joint's frame to the character's space when the mesh was bound, column-major. */
function bindOf({ skeleton, skin }: Character, joint: number): mat4 {
  const entry = skin.paletteJoint.indexOf(joint);
  const jointFromBind = skin.jointFromBind.subarray(entry * 16, entry * 16 + 16);
  const bind: mat4 = new Float64Array(16);
  if (entry >= 0 && mat4.invert(bind, jointFromBind)) return bind;
  return jointMatrices(skeleton, skeleton.qRest).subarray(joint * 16, joint * 16 + 16);
}
