import { type Bounds, emptyBounds, includePositions } from '../core/bounds.ts';
import type { Character } from '../core/character.ts';
import { boxCorners } from '../core/display-boxes.ts';

/**
 * Returns the box around a posed character's vertices and joints, and around its display boxes if
 * there is no mesh, in character space.
 *
 * @param positions (vertexCount × 3) posed
 * @param characterFromJoint (jointCount × 16)
 */
export function posedBounds(
  { mesh, skeleton }: Character,
  positions: Float32Array,
  characterFromJoint: Float64Array,
): Bounds {
  const bounds = emptyBounds();
  includePositions(bounds, positions, mesh.vertexCount);
  for (let at = 12; at < characterFromJoint.length; at += 16) {
    includePositions(bounds, characterFromJoint.subarray(at, at + 3), 1);
  }
  if (mesh.pointCount === 0) {
    const corners = boxCorners(skeleton, characterFromJoint);
    includePositions(bounds, corners, corners.length / 3);
  }
  return bounds;
}
