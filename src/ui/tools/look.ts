import { firstPersonFrom, lookAround, orbitFrom } from '../../view/first-person.ts';
import type { Tool } from '../tool.ts';

/** Radians for a drag over the height of the view. */
const turnPerHeight = 2;

/** In first person, a left drag turns the camera in place. */
export const lookTool: Tool = {
  id: 'look',
  poses: false,
  press(_, button, { session, viewer: { camera } }) {
    if (!session.firstPerson.value || button !== 0) return null;
    return {
      move({ place: { viewHeight }, deltaX, deltaY }) {
        const [left, up] = [deltaX / viewHeight, deltaY / viewHeight];
        const view = firstPersonFrom(camera.value);
        camera.value = orbitFrom(lookAround(view, left * turnPerHeight, up * turnPerHeight));
      },
      end: () => undefined,
      cancel: () => undefined,
    };
  },
};
