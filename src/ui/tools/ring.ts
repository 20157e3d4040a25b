import { setPose } from '../../document/edits.ts';
import { ringTurn, seenRing, turnRing } from '../../posing/ring-turn.ts';
import { eyeOf } from '../../view/camera.ts';
import type { GizmoRing } from '../../view/gizmo.ts';
import { pixelsIn } from '../../view/overlay.ts';
import { overlayViewAt, pixelsAt } from '../../view/overlay-place.ts';
import { ringAt } from '../../view/pick-gizmo.ts';
import type { Looking } from '../editor.ts';
import { showHoveredHandle } from '../hover.ts';
import { axisNames } from '../joint-values.ts';
import {
  distanceBetween,
  stillDistance,
  type Tool,
  type ToolDrag,
  type ToolPlace,
} from '../tool.ts';

/** With Ctrl or Cmd, in radians. */
const snapStep = Math.PI / 12;
/** How much less the pointer does with Shift. */
const fine = 0.1;

/** A left drag on a ring of the selected joint turns one angle; a click makes it the active one. */
export const ringTool: Tool = {
  id: 'ring',
  poses: true,
  press(place, button, editor) {
    const ring = button === 0 ? ringAt(editor, place) : null;
    if (!ring) return null;
    showHoveredHandle(editor, ring.id);
    return turnByRing(editor, place, ring);
  },
};

/**
 * A drag depends only on its start. When Shift is pressed or released, it starts again from the
 * pose of that moment.
 */
function turnByRing(editor: Looking, pressed: ToolPlace, { ring, ...place }: GizmoRing): ToolDrag {
  const { store, session, viewer, evaluations } = editor;
  const { state, poseToEdit } = evaluations.selected()!;
  const { skeleton } = state.character;
  const { index, ballAxis } = ring;
  const jointName = skeleton.names[session.selectedJoint.value!]!;
  const name = `${jointName} ${axisNames[ring.axis]}`;
  session.activeDof.value = {
    isChosen: false,
    ...{ name, index, isAngle: true },
    ...(ballAxis === undefined ? {} : { ballAxis }),
  };
  const view = overlayViewAt(editor, pressed);
  const seen = seenRing(place, eyeOf(viewer.viewCamera.value), pixelsIn(view));
  const label = `Turn ${name}`;
  const gesture = store.begin(label);
  let present: Float64Array = poseToEdit.q.slice();
  let start = { q: present, at: pressed };
  let turn = 0;
  let moved = false;

  return {
    move({ place: to }) {
      moved ||= distanceBetween(pressed, to) > stillDistance;
      // After the drag was canceled or ended by an undo, it has no effect until the button is
      // released.
      if (!moved || !gesture.isOpen) return;
      if (to.shift !== start.at.shift) {
        start = { q: present, at: to };
        turn = 0;
      }
      turn = ringTurn(seen, pixelsAt(view, start.at), pixelsAt(view, to), turn);
      const scaled = to.shift ? turn * fine : turn;
      present = turnRing(skeleton, start.q, ring, scaled, to.control ? snapStep : 0);
      gesture.preview(setPose(state.id, present, label));
    },
    end: () => gesture.commit(),
    cancel: () => gesture.cancel(),
  };
}
