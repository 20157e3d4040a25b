import { setPose } from '../../document/edits.ts';
import { selectedJoints } from '../../document/selected-joints.ts';
import type { FreeRing } from '../../posing/free-rings.ts';
import { parentMatrix } from '../../posing/joint-frames.ts';
import { type JointRing, jointRings } from '../../posing/joint-rings.ts';
import { ringTurn, seenRing, snappedTurn, turnRing } from '../../posing/ring-turn.ts';
import { turnSeveral } from '../../posing/turn-several.ts';
import { eyeOf } from '../../view/camera.ts';
import { type GizmoRing, isOwnRing } from '../../view/gizmo.ts';
import { pixelsIn } from '../../view/overlay.ts';
import { overlayViewAt, pixelsAt } from '../../view/overlay-place.ts';
import { ringAt } from '../../view/pick-gizmo.ts';
import { formatDegrees } from '../angle-text.ts';
import type { Looking } from '../editor.ts';
import { showHoveredHandle } from '../hover.ts';
import { axisNames } from '../joint-values.ts';
import {
  distanceBetween,
  fine,
  stillDistance,
  type Tool,
  type ToolDrag,
  type ToolPlace,
} from '../tool.ts';

/** With Ctrl or Cmd, in radians. */
const snapStep = Math.PI / 12;

/**
 * A left drag on a ring of the selected joint turns one angle, or the joint about an axis of the
 * scene or the line of sight; with it, by the same angle, all joints that are selected. A click on a
 * ring makes its angle the active one.
 */
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

/** What a ring does with a pose. */
interface Turning {
  /** What is turned: "Left elbow X". */
  readonly name: string;
  /** Returns the angle to turn by, which is `turn` or, in steps, the nearest one to it. */
  snapped(q: Float64Array, turn: number, step: number): number;
  /** @param present the pose that is shown now */
  turned(q: Float64Array, angle: number, present: Float64Array): Float64Array;
}

/**
 * A drag depends only on its start. When Shift is pressed or released, it starts again from the
 * pose of that moment.
 */
function turnByRing(editor: Looking, pressed: ToolPlace, ring: GizmoRing): ToolDrag {
  const { store, session, viewer, evaluations } = editor;
  const { state, poseToEdit } = evaluations.selected()!;
  const turning = isOwnRing(ring.ring)
    ? turningOwn(editor, ring.ring)
    : turningFreely(editor, ring.ring);
  const view = overlayViewAt(editor, pressed);
  const seen = seenRing(ring, eyeOf(viewer.viewCamera.value), pixelsIn(view));
  const label = `Turn ${turning.name}`;
  const gesture = store.begin(label);
  let present: Float64Array = poseToEdit.q.slice();
  let start = { q: present, at: pressed, angle: 0 };
  let turn = 0;
  let angle = 0;
  let moved = false;
  const finish = (end: () => void): void => {
    end();
    session.dragText.value = null;
  };

  return {
    move({ place: to }) {
      moved ||= distanceBetween(pressed, to) > stillDistance;
      // After the drag was canceled or ended by an undo, it has no effect until the button is
      // released.
      if (!gesture.isOpen) session.dragText.value = null;
      if (!moved || !gesture.isOpen) return;
      if (to.shift !== start.at.shift) {
        start = { q: present, at: to, angle };
        turn = 0;
      }
      turn = ringTurn(seen, pixelsAt(view, start.at), pixelsAt(view, to), turn);
      const scaled = to.shift ? turn * fine : turn;
      const own = turning.snapped(start.q, scaled, to.control ? snapStep : 0);
      angle = start.angle + own;
      present = turning.turned(start.q, own, present);
      // An angle of its own is shown with its value.
      if (!isOwnRing(ring.ring)) {
        session.dragText.value = `${turning.name} ${formatDegrees(angle)}`;
      }
      gesture.preview(setPose(state.id, present, label));
    },
    end: () => finish(() => gesture.commit()),
    cancel: () => finish(() => gesture.cancel()),
  };
}

/** Turns one angle of the selected joint, and that about the same axis of the others. */
function turningOwn({ session, evaluations }: Looking, ring: JointRing): Turning {
  const { state, poseToEdit } = evaluations.selected()!;
  const { skeleton } = state.character;
  const [joint, ...others] = selectedJoints(session);
  const { index, ballAxis } = ring;
  const name = `${skeleton.names[joint!]!} ${axisNames[ring.axis]}`;
  session.activeDof.value = {
    isChosen: false,
    ...{ name, index, isAngle: true },
    ...(ballAxis === undefined ? {} : { ballAxis }),
  };
  const alike = others.flatMap((other) =>
    jointRings(
      skeleton,
      other,
      poseToEdit.q,
      parentMatrix(skeleton, other, poseToEdit.q),
      null,
    ).filter(({ axis }) => axis === ring.axis),
  );
  return {
    name: namedWith(name, others.length),
    snapped: (q, turn, step) => snappedTurn(ballAxis === undefined ? q[index]! : null, turn, step),
    turned: (q, angle) =>
      [ring, ...alike].reduce((turned, each) => turnRing(skeleton, turned, each, angle), q),
  };
}

/** Turns each selected joint about one axis. */
function turningFreely({ session, evaluations }: Looking, { axis, normal }: FreeRing): Turning {
  const { skeleton } = evaluations.selected()!.state.character;
  const joints = selectedJoints(session);
  const about = axis === null ? 'in the view' : `about the scene’s ${axisNames[axis]}`;
  return {
    name: `${namedWith(skeleton.names[joints[0]!]!, joints.length - 1)} ${about}`,
    snapped: (_, turn, step) => snappedTurn(null, turn, step),
    turned: (q, angle, present) => turnSeveral(skeleton, q, joints, normal, angle, present),
  };
}

function namedWith(name: string, others: number): string {
  return others === 0 ? name : `${name} and ${others} more`;
}
