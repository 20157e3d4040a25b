import { type mat4, vec3 } from 'gl-matrix';
import { type Bounds, emptyBounds, includePositions, isEmpty } from '../core/bounds.ts';
import type { Evaluation } from './evaluation.ts';

/** Returns the box around characters as they are placed now, in scene space. */
export function sceneBounds(evaluations: readonly Evaluation[]): Bounds {
  const all = emptyBounds();
  for (const evaluation of evaluations) {
    includeBox(all, evaluation.bounds(), evaluation.display.sceneFromCharacter);
  }
  return all;
}

function includeBox(all: Bounds, box: Bounds, sceneFromCharacter: mat4): void {
  if (isEmpty(box)) return;
  for (let corner = 0; corner < 8; corner++) {
    const [x, y, z] = [0, 1, 2].map((i) => (corner & (1 << i) ? box.max : box.min)[i]!);
    vec3.set(point, x!, y!, z!);
    includePositions(all, vec3.transformMat4(point, point, sceneFromCharacter), 1);
  }
}

const point: vec3 = new Float64Array(3);
