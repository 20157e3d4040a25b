import { setPose } from '../../document/edits.ts';
import { jointOfValue } from '../../core/pose.ts';
import { beginDrag, type DragMode, type DragPointer } from '../../posing/drag.ts';
import { axesOf } from '../../view/camera.ts';
import { boneAt, type BoneTarget, characterRayAt } from '../../view/pick.ts';
import { sizeOfPixel } from '../../view/picking.ts';
import type { Looking } from '../editor.ts';
import { anyIsLive, isLive } from '../live-limb.ts';
import { showHover } from '../hover.ts';
import {
  distanceBetween,
  stillDistance,
  type Tool,
  type ToolDrag,
  type ToolPlace,
} from '../tool.ts';

/** A grabbed point that is nearer than this to its joint does not follow; CSS pixels. */
const leastReach = 8;

/** A left drag on the selected limb, in bone mode on any, turns it by its bone or its skin. */
export const boneTool: Tool = {
  id: 'bone',
  poses: true,
  press(place, button, editor) {
    if (button !== 0 || !anyIsLive(editor.session)) return null;
    const target = boneAt(editor, place);
    if (!target || !isLive(editor, target)) return null;
    showHover(editor, place, target);
    return turnBone(editor, place, target);
  },
};

/**
 * A drag depends only on its start, so that moving the pointer back restores the pose. With Alt it
 * rolls the bone. When Alt is pressed or released, the drag starts again from the pose of that
 * moment.
 */
function turnBone(editor: Looking, from: ToolPlace, target: BoneTarget): ToolDrag {
  const { store, session, viewer, evaluations } = editor;
  const { state, poseToEdit } = evaluations.selected()!;
  const { skeleton } = state.character;
  const label = `Turn ${skeleton.names[target.joint]!}`;
  const gesture = store.begin(label);
  let present: Float64Array = poseToEdit.q.slice();
  let { alt } = from;
  let drag = start(from, target.grabbed);
  let moved = false;

  return {
    move({ place }) {
      moved ||= distanceBetween(from, place) > stillDistance;
      // After the drag was canceled or ended by an undo, it has no effect until the button is
      // released.
      if (!moved || !gesture.isOpen) return;
      if (place.alt !== alt) {
        alt = place.alt;
        drag = start(place, drag.grabbedAt(present));
      }
      present = drag.move(pointerAt(place), present);
      session.hoverPlace.value = [place.pixelX, place.pixelY];
      gesture.preview(setPose(state.id, present, label));
    },
    end: () => gesture.commit(),
    cancel: () => gesture.cancel(),
  };

  function start(place: ToolPlace, grabbed: readonly [number, number, number]) {
    const camera = viewer.viewCamera.value;
    const pixel = sizeOfPixel(camera, place.viewHeight) * target.distance;
    return beginDrag({
      skeleton,
      q: present,
      joint: target.joint,
      grabbed,
      pointer: pointerAt(place),
      view: axesOf(camera),
      mode: modeOf(),
      leastReach: leastReach * pixel,
    });
  }

  function modeOf(): DragMode {
    if (alt && target.bone) return { kind: 'roll', farEnd: target.bone.vector };
    const active = session.activeDof.value;
    // A ball's three sliders have no values of their own in q, so a ball rotates freely.
    const isValue = active?.isChosen === true && active.ballAxis === undefined;
    if (isValue && jointOfValue(skeleton, active.index) === target.joint) {
      return { kind: 'value', index: active.index };
    }
    return { kind: state.look.dragging };
  }

  function pointerAt(place: ToolPlace): DragPointer {
    return { ray: characterRayAt(editor, place), x: place.pixelX, y: -place.pixelY };
  }
}
