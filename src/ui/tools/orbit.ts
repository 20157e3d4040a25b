import { orbit, pan, zoom } from '../../view/camera.ts';
import type { Editor } from '../editor.ts';
import type { Tool, ToolPlace } from '../tool.ts';

/** Radians for a drag over the height of the view. */
const turnPerHeight = 4;
const zoomPerHeight = 3;

/**
 * The camera by mouse, as in the course's program: left orbits, middle pans, right zooms. Hovering
 * lights a joint, a click selects it.
 */
export const orbitTool: Tool = {
  id: 'orbit',
  drag({ button, deltaX, deltaY, viewHeight }, { viewer: { camera } }) {
    const [x, y] = [deltaX / viewHeight, deltaY / viewHeight];
    if (button === 1) camera.value = pan(camera.value, -x, y);
    else if (button === 2) camera.value = zoom(camera.value, Math.exp(y * zoomPerHeight));
    else camera.value = orbit(camera.value, -x * turnPerHeight, y * turnPerHeight);
  },
  hover(place, editor) {
    editor.session.hoveredJoint.value = place && jointAt(place, editor);
  },
  click(place, editor) {
    const joint = jointAt(place, editor);
    if (joint !== null) editor.session.selectedJoint.value = joint;
  },
};

function jointAt({ x, y, tolerance, viewHeight }: ToolPlace, { viewer }: Editor): number | null {
  return viewer.pick(x, y, tolerance, viewHeight);
}
