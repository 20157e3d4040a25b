import { boxCorners } from '../core/display-boxes.ts';
import type { Evaluation } from './evaluation.ts';

/**
 * Returns the height (y in the scene) of the lowest posed vertex of a character as it is placed, or
 * of its joints and display boxes if it has no mesh; Infinity if it has neither.
 */
export function lowestPoint(evaluation: Evaluation): number {
  const { state, display, characterFromJoint } = evaluation;
  const { mesh, skeleton } = state.character;
  const m = display.sceneFromCharacter;
  let lowest = Infinity;
  const include = (positions: ArrayLike<number>, count: number, stride: number, from = 0): void => {
    for (let i = 0, at = from; i < count; i++, at += stride) {
      const [x, y, z] = [positions[at]!, positions[at + 1]!, positions[at + 2]!];
      lowest = Math.min(lowest, m[1]! * x + m[5]! * y + m[9]! * z + m[13]!);
    }
  };
  if (mesh.vertexCount > 0) {
    include(evaluation.vertices().positions, mesh.vertexCount, 3);
    return lowest;
  }
  include(characterFromJoint, skeleton.jointCount, 16, 12);
  const corners = boxCorners(skeleton, characterFromJoint);
  include(corners, corners.length / 3, 3);
  return lowest;
}
