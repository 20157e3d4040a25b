import { vec3 } from 'gl-matrix';
import { diagonal, emptyBounds, includePositions, isEmpty } from '../core/bounds.ts';
import type { Evaluation } from '../evaluation/evaluation.ts';

/**
 * A sphere around the characters as they are placed now, for lights and shadows, in scene space.
 */
export interface Subject {
  readonly center: vec3;
  readonly radius: number;
}

/**
 * Uses the posed joints and the size at rest, which is accurate enough, and fast enough for every
 * pose.
 */
export function subjectOf(characters: readonly Evaluation[]): Subject {
  const joints = emptyBounds();
  let size = 0;
  for (const { display, characterFromJoint, state } of characters) {
    size = Math.max(size, diagonal(state.character.bounds) * display.scale);
    for (let at = 12; at < characterFromJoint.length; at += 16) {
      vec3.set(
        point,
        characterFromJoint[at]!,
        characterFromJoint[at + 1]!,
        characterFromJoint[at + 2]!,
      );
      vec3.transformMat4(point, point, display.sceneFromCharacter);
      includePositions(joints, point, 1);
    }
  }
  if (isEmpty(joints)) return { center: [0, 0.5, 0], radius: size / 2 };
  const center = vec3.lerp(new Float64Array(3), joints.min, joints.max, 0.5);
  return { center, radius: Math.max(size * 0.6, diagonal(joints) / 2 + size * 0.2) };
}

const point: vec3 = new Float64Array(3);
