import { orbit, pan, zoom } from '../../view/camera.ts';
import { pickAt } from '../../view/pick.ts';
import type { Tool } from '../tool.ts';

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
    editor.session.hoveredJoint.value = place && pickAt(editor, place);
  },
  click(place, editor) {
    const joint = pickAt(editor, place);
    if (joint !== null) editor.session.selectedJoint.value = joint;
  },
};
