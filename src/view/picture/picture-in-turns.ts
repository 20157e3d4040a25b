import type { Camera } from '../../document/camera.ts';
import type { Actor } from '../../document/scene.ts';
import { gpuDone } from '../../gl/fence.ts';
import { RenderTarget } from '../../gl/render-target.ts';
import { turnOfPage } from '../turn-of-page.ts';
import type { Viewer } from '../viewer.ts';
import type { Picture } from './encode-picture.ts';
import { averaged, drawAlone, holdAlone } from './pose-picture.ts';

/**
 * Draws a picture as `posePicture` does, from another camera. The page goes on between its steps, and
 * while the GPU draws.
 *
 * @returns null if the signal or the loss of the graphics context ends it
 */
export async function pictureInTurns(
  viewer: Viewer,
  actor: Actor,
  camera: Camera,
  side: number,
  signal: AbortSignal,
): Promise<Picture | null> {
  const held = holdAlone(viewer, actor);
  const { still } = held;
  const goesOn = async (): Promise<boolean> => {
    await turnOfPage();
    return !signal.aborted && viewer.available.value;
  };
  let target: RenderTarget | null = null;
  try {
    if (!(await goesOn())) return null;
    target = drawAlone(viewer, still, camera, side, (renderer, frame) => {
      const { width, height } = frame.viewport;
      const drawn = new RenderTarget(renderer.gpu, width, height);
      renderer.drawInto(drawn, [frame]);
      return drawn;
    });
    viewer.requestFrame(); // drawing of any kind empties the canvas
    await gpuDone(viewer.present().gpu);
    if (!(await goesOn())) return null;
    const pixels = target.readPixels();
    if (!(await goesOn())) return null;
    return averaged(pixels, side);
  } finally {
    target?.dispose();
    held.release();
  }
}
