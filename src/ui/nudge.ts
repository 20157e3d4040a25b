import { movedBy, scaledBy, setTransform, turnedBy } from '../document/place-edits.ts';
import type { Transform } from '../document/scene.ts';
import { selectedActor } from '../document/selected-actor.ts';
import { axesOf } from '../view/camera.ts';
import { axisOf } from '../view/place-gizmo.ts';
import type { Looking } from './editor.ts';
import { heldGesture } from './held-gesture.ts';
import { placeLabel, placeSteps } from './place-steps.ts';

/** A direction of the keys: along the picture's width, into the picture, and upward. */
export type NudgeAxis = 'right' | 'ahead' | 'up';

/**
 * Moves, turns or scales the selected character by one step. Moving follows the axis that is
 * nearest to the direction as the picture shows it. A key that is held makes one step of undo.
 */
export function nudge(editor: Looking, axis: NudgeAxis, sign: 1 | -1): void {
  const { store, session } = editor;
  const actor = selectedActor(store, session);
  const tool = session.placeTool.value;
  if (!actor || !tool) return;
  const label = placeLabel(tool, actor);
  const next = nudged(editor, actor.transform, axis, sign);
  heldGesture(store, label).preview(setTransform(actor.id, next, label));
}

function nudged(
  { session, viewer }: Looking,
  transform: Transform,
  axis: NudgeAxis,
  sign: 1 | -1,
): Transform {
  const axes = session.placeAxes.value;
  const isOwn = axes === 'local';
  if (session.placeTool.value === 'scale') {
    const larger = transform.scale + sign * placeSteps.scale;
    return scaledBy(transform, larger / transform.scale, placeSteps.scale);
  }
  if (session.placeTool.value === 'turn') {
    // The keys turn what faces the viewer to the right, backward, and to its side.
    const about = { right: 1, ahead: 0, up: 2 } as const;
    const angle = (axis === 'ahead' ? -sign : sign) * placeSteps.turn;
    return turnedBy(transform, axisOf(transform, 'world', about[axis]), angle, isOwn);
  }
  const { right, look } = axesOf(viewer.camera.value);
  const [x, z] = [axisOf(transform, axes, 0), axisOf(transform, axes, 2)];
  const toward = axis === 'right' ? right : [look[0], 0, look[2]];
  const part = (unit: ArrayLike<number>): number => unit[0]! * toward[0] + unit[2]! * toward[2];
  const nearest = Math.abs(part(x)) >= Math.abs(part(z)) ? x : z;
  const unit = axis === 'up' ? axisOf(transform, axes, 1) : nearest;
  const amount = sign * placeSteps.move * (axis === 'up' ? 1 : Math.sign(part(nearest)) || 1);
  const vector = [unit[0] * amount, unit[1] * amount, unit[2] * amount] as const;
  return movedBy(transform, vector, isOwn ? 0 : placeSteps.move);
}
