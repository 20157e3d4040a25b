import { vec3 } from 'gl-matrix';
import { type Bounds, emptyBounds, includePositions } from '../core/bounds.ts';
import { boxCorners } from '../core/display-boxes.ts';
import { worldMatrices } from '../core/forward-kinematics.ts';
import { type CharacterState, skinInUse } from '../document/document.ts';
import { shownPose } from '../document/shown-pose.ts';
import { methodById } from '../skinning/registry.ts';
import { skinVertices } from '../skinning/skin-vertices.ts';
import { displayTransform } from './display-transform.ts';

/**
 * The box of a character as it stands now, skin and joints, scene space.
 * @param time seconds of the bound clip
 */
export function posedBounds(state: CharacterState, time: number): Bounds {
  const { character, method } = state;
  const pose = shownPose(state, time);
  const { sceneFromCharacter } = displayTransform(character);
  const bounds = emptyBounds();
  const { positions } = skinVertices(character, skinInUse(state), pose, methodById(method));
  const worldFromJoint = worldMatrices(character.skeleton, pose.q);
  for (let at = 0; at < positions.length; at += 3) include(positions, at);
  for (let at = 12; at < worldFromJoint.length; at += 16) include(worldFromJoint, at);
  if (character.mesh.pointCount === 0) {
    const corners = boxCorners(character.skeleton, worldFromJoint);
    for (let at = 0; at < corners.length; at += 3) include(corners, at);
  }
  return bounds;

  function include(from: ArrayLike<number>, at: number): void {
    vec3.set(point, from[at]!, from[at + 1]!, from[at + 2]!);
    includePositions(bounds, vec3.transformMat4(point, point, sceneFromCharacter), 1);
  }
}

/** The box about all of them. */
export function unite(boxes: readonly Bounds[]): Bounds {
  const all = emptyBounds();
  for (const { min, max } of boxes) {
    includePositions(all, min, 1);
    includePositions(all, max, 1);
  }
  return all;
}

const point: vec3 = new Float64Array(3);
