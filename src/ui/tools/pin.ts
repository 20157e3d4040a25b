import { rayInFrame } from '../../core/ray.ts';
import { movePin, pinOf } from '../../document/pin-edits.ts';
import { shownPins } from '../../evaluation/shown-state.ts';
import { selectActor } from '../../document/reconcile.ts';
import type { Pin } from '../../posing/pins/pin.ts';
import { slideOnPlane } from '../../posing/slide.ts';
import { axesOf } from '../../view/camera.ts';
import { characterRayAt } from '../../view/pick.ts';
import { pinAt } from '../../view/pick-pin.ts';
import type { Looking } from '../editor.ts';
import { showHoveredHandle } from '../hover.ts';
import {
  distanceBetween,
  stillDistance,
  type Tool,
  type ToolDrag,
  type ToolPlace,
} from '../tool.ts';

/** A left drag on the diamond of a pin moves its place, unless it follows another character. */
export const pinTool: Tool = {
  id: 'pin',
  poses: true,
  press(place, button, editor) {
    const handle = button === 0 ? pinAt(editor, place) : null;
    if (!handle || handle.follows) return null;
    const { session, store, evaluations } = editor;
    selectActor(session, store.scene.value, handle.actorId);
    const pin = pinOf(shownPins(evaluations.selected()!).state, handle.joint)!;
    showHoveredHandle(editor, handle.id);
    return dragPin(editor, place, pin);
  },
};

/**
 * The place goes on the plane through it that faces the camera, as far as the pointer goes. A drag
 * depends only on its start.
 */
function dragPin(editor: Looking, from: ToolPlace, { joint, place }: Pin): ToolDrag {
  const { store, evaluations, viewer } = editor;
  const shown = evaluations.selected()!;
  const { display } = shown;
  const { state } = shownPins(shown);
  const edit = (by: readonly number[]) =>
    movePin(state, joint, [place[0] + by[0]!, place[1] + by[1]!, place[2] + by[2]!]);
  const { look } = axesOf(viewer.viewCamera.value);
  const across = rayInFrame({ origin: [0, 0, 0], direction: look }, display.sceneFromCharacter);
  const start = characterRayAt(editor, from);
  const gesture = store.begin(edit([0, 0, 0]).label);
  let moved = false;

  return {
    move({ place: to }) {
      moved ||= distanceBetween(from, to) > stillDistance;
      if (!moved || !gesture.isOpen) return;
      const by = slideOnPlane([...place], across.direction, start, characterRayAt(editor, to));
      if (by) gesture.preview(edit([by[0], by[1], by[2]]));
    },
    end: () => gesture.commit(),
    cancel: () => gesture.cancel(),
  };
}
