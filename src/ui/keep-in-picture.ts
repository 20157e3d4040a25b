import { type mat4, vec4 } from 'gl-matrix';
import type { Bounds } from '../core/bounds.ts';
import { sceneBounds } from '../evaluation/scene-bounds.ts';
import { clipFromScene } from '../view/camera.ts';
import type { Editor } from './editor.ts';

/** Lets the camera step back if a part of a character is beside the picture, unless the user has moved it. */
export async function keepInPicture({ evaluations, viewer }: Editor): Promise<void> {
  await evaluations.settled();
  const box = sceneBounds(evaluations.visible());
  const isSeen = isInPicture(box, clipFromScene(viewer.camera.value, viewer.aspect));
  if (!isSeen && viewer.isFramed) viewer.frame(box);
}

/** Whether all corners of a box in scene space are in the picture. */
function isInPicture({ min, max }: Bounds, clipFromScene: mat4): boolean {
  const at = vec4.create();
  for (let corner = 0; corner < 8; corner++) {
    const [x, y, z] = [0, 1, 2].map((axis) => (corner & (1 << axis) ? max : min)[axis]!);
    vec4.transformMat4(at, [x!, y!, z!, 1], clipFromScene);
    if (Math.max(Math.abs(at[0]), Math.abs(at[1])) > at[3]) return false;
  }
  return true;
}
