import { type Bounds, isEmpty } from '../core/bounds.ts';
import type { Transform } from '../document/scene.ts';
import type { Evaluation } from './evaluation.ts';
import { gap } from './placing.ts';
import { sceneBounds } from './scene-bounds.ts';

/**
 * Returns the place of a copy of a character: as high and as deep as it, to the right of everything
 * that is in the scene.
 *
 * @param taken the box around what is in the scene, in scene space
 */
export function placeBeside(taken: Bounds, original: Evaluation): Transform {
  const { transform } = original.state;
  const own = sceneBounds([original]);
  if (isEmpty(own)) return transform;
  const [x, y, z] = transform.position;
  return { ...transform, position: [x + taken.max[0]! + gap - own.min[0]!, y, z] };
}
