import { zoom } from '../../view/camera.ts';
import { orbit, pan } from '../../view/camera-moves.ts';
import type { Tool } from '../tool.ts';

/** Radians for a drag over the height of the view. */
const turnPerHeight = 4;
const zoomPerHeight = 3;

/**
 * Moves the camera with the mouse, as in 6.837's program: left orbits, middle pans, right zooms.
 */
export const orbitTool: Tool = {
  id: 'orbit',
  poses: false,
  press: (_, button, { viewer: { camera, viewCamera } }) => ({
    move({ place: { viewHeight }, deltaX, deltaY }) {
      const [x, y] = [deltaX / viewHeight, deltaY / viewHeight];
      if (button === 1) {
        camera.value = { ...camera.value, target: pan(viewCamera.value, -x, y).target };
      } else if (button === 2) camera.value = zoom(camera.value, Math.exp(y * zoomPerHeight));
      else camera.value = orbit(camera.value, -x * turnPerHeight, y * turnPerHeight);
    },
    end: () => undefined,
    cancel: () => undefined,
  }),
};
