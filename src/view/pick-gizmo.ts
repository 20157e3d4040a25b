import type { HandleId } from '../document/session.ts';
import type { Evaluation } from '../evaluation/evaluation.ts';
import { gizmoOf, type GizmoRing, gizmoRings } from './gizmo.ts';
import { moveGizmoOf, type MoveHandle, moveHandles } from './move-gizmo.ts';
import { type Overlay, type OverlayView, pickOverlay } from './overlay.ts';
import { overlayViewAt, pixelsAt } from './overlay-place.ts';
import { boneAt, type Looking, type PickPlace } from './pick.ts';
import {
  floorHandle,
  type PlaceHandle,
  placeGizmoOf,
  placeHandles,
  placeShapes,
  viewHandle,
} from './place-gizmo.ts';
import { lightAt } from './pick-light.ts';
import { targetAt } from './ik-targets.ts';
import { pinAt } from './pick-pin.ts';
import { gizmoLines } from './ring-lines.ts';
import { sessionOptionsOf } from './view-options.ts';

/** Returns the ring of the selected joint at a place of the view, or null. */
export function ringAt(look: Looking, place: PickPlace): GizmoRing | null {
  const options = sessionOptionsOf(look.session);
  const gizmo = gizmoOf(options);
  const shown = selectedInView(look);
  // With inverse kinematics the handles of the target stand there instead.
  if (!gizmo || !shown || moveGizmoOf(options)?.isTarget) return null;
  const view = overlayViewAt(look, place);
  const rings = gizmoRings(shown, view, gizmo);
  return nearest(rings, gizmoLines(rings, gizmo), view, place);
}

/** Returns the handle that moves the selected joint at a place of the view, or null. */
export function moveHandleAt(look: Looking, place: PickPlace): MoveHandle | null {
  const gizmo = moveGizmoOf(sessionOptionsOf(look.session));
  const shown = selectedInView(look);
  if (!gizmo || !shown) return null;
  const view = overlayViewAt(look, place);
  const handles = moveHandles(shown, view, gizmo);
  return nearest(handles, placeShapes(handles, gizmo), view, place);
}

/** Returns all handles of the whole selected character that a view shows. */
function shownPlaceHandles(look: Looking, view: OverlayView): readonly PlaceHandle[] {
  const gizmo = placeGizmoOf(sessionOptionsOf(look.session));
  const shown = selectedInView(look);
  return gizmo && shown ? placeHandles(shown.state, view, gizmo) : [];
}

/** Returns the handle of the whole selected character at a place of the view, or null. */
export function placeHandleAt(look: Looking, place: PickPlace): PlaceHandle | null {
  const gizmo = placeGizmoOf(sessionOptionsOf(look.session));
  if (!gizmo) return null;
  const view = overlayViewAt(look, place);
  const handles = shownPlaceHandles(look, view);
  return nearest(handles, placeShapes(handles, gizmo), view, place);
}

/**
 * Returns the handle that moves the selected character over the floor, if that is what the tool
 * does and the character's body is at a place of the view; otherwise null.
 */
export function bodyHandleAt(look: Looking, place: PickPlace): PlaceHandle | null {
  const { placeTool, selectedActorId } = look.session;
  if (placeTool.value !== 'move') return null;
  const handles = shownPlaceHandles(look, overlayViewAt(look, place));
  if (handles.length === 0 || boneAt(look, place)?.actorId !== selectedActorId.value) return null;
  // The floor can't be dragged over while it is seen edge-on.
  const byId = (id: HandleId) => handles.find((handle) => handle.id === id);
  return byId(floorHandle) ?? byId(viewHandle) ?? null;
}

/** Returns the id of the handle at a place of the view, or null. */
export function handleAt(look: Looking, place: PickPlace): HandleId | null {
  const handle =
    lightAt(look, place) ??
    pinAt(look, place) ??
    targetAt(look, place) ??
    ringAt(look, place) ??
    moveHandleAt(look, place) ??
    placeHandleAt(look, place);
  return handle?.id ?? null;
}

function nearest<T extends { readonly id: HandleId }>(
  handles: readonly T[],
  shapes: Overlay,
  view: OverlayView,
  place: PickPlace,
): T | null {
  const id = pickOverlay(shapes, view, pixelsAt(view, place), place.tolerance);
  return handles.find((handle) => handle.id === id) ?? null;
}

/** The selected character, unless it is hidden. */
function selectedInView({ evaluations }: Looking): Evaluation | undefined {
  const shown = evaluations.selected();
  return shown?.state.look.visible ? shown : undefined;
}
