import { setLight } from '../../document/environment-edits.ts';
import { isInFront, type LightAngles, lightAnglesAt } from '../../view/light-drag.ts';
import type { LightHandle } from '../../view/light-handles.ts';
import { pixelsIn } from '../../view/overlay.ts';
import { overlayViewAt, pixelsAt } from '../../view/overlay-place.ts';
import { lightAt } from '../../view/pick-light.ts';
import type { Looking } from '../editor.ts';
import { showHoveredHandle } from '../hover.ts';
import {
  distanceBetween,
  stillDistance,
  type Tool,
  type ToolDrag,
  type ToolPlace,
} from '../tool.ts';

/** In degrees: without, and with Ctrl or Cmd. */
const [step, snapStep] = [0.1, 15];
/** Higher, a light would have no direction around. */
const highest = 89;

/** A left drag on the disc of a light moves it around what it shines on. */
export const lightTool: Tool = {
  id: 'light',
  poses: true,
  press(place, button, editor) {
    const handle = button === 0 ? lightAt(editor, place) : null;
    if (!handle) return null;
    showHoveredHandle(editor, handle.id);
    return moveLight(editor, place, handle);
  },
};

/** A drag depends only on its start. */
function moveLight(editor: Looking, pressed: ToolPlace, { index, place }: LightHandle): ToolDrag {
  const { store } = editor;
  const light = store.scene.value.environment.lights[index]!;
  const label = `${light.name} light's direction`;
  const view = overlayViewAt(editor, pressed);
  const front = isInFront(light, view);
  const [seenX, seenY] = pixelsIn(view)(place);
  const [startX, startY] = pixelsAt(view, pressed);
  const gesture = store.begin(label);
  let moved = false;

  return {
    move({ place: to }) {
      moved ||= distanceBetween(pressed, to) > stillDistance;
      // After the drag was canceled or ended by an undo, it has no effect until the button is
      // released.
      if (!moved || !gesture.isOpen) return;
      const [x, y] = pixelsAt(view, to);
      const angles = lightAnglesAt(view, [seenX + x - startX, seenY + y - startY], front);
      gesture.preview(setLight(index, rounded(angles, to.control ? snapStep : step), label));
    },
    end: () => gesture.commit(),
    cancel: () => gesture.cancel(),
  };
}

function rounded({ azimuth, elevation }: LightAngles, unit: number): LightAngles {
  const round = (angle: number): number => Number((Math.round(angle / unit) * unit).toFixed(1));
  return {
    azimuth: round(azimuth),
    elevation: Math.max(-highest, Math.min(highest, round(elevation))),
  };
}
