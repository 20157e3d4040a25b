import type { HandleId } from '../document/session.ts';
import { gizmoLines, gizmoOf, type GizmoRing, gizmoRings } from './gizmo.ts';
import { type OverlayView, pickOverlay } from './overlay.ts';
import type { Looking, PickPlace } from './pick.ts';
import { sessionOptionsOf } from './view-options.ts';

/** Returns the view at a place as the overlay sees it; its pixels are CSS pixels. */
export function overlayViewAt({ viewer }: Looking, { viewHeight }: PickPlace): OverlayView {
  const width = viewHeight * viewer.aspect;
  return { camera: viewer.viewCamera.value, width, height: viewHeight };
}

/** The place in pixels from the view's middle, y up. */
export function pixelsAt(view: OverlayView, { x, y }: PickPlace): [number, number] {
  return [(x * view.width) / 2, (y * view.height) / 2];
}

/** Returns the ring of the selected joint at a place of the view, or null. */
export function ringAt(look: Looking, place: PickPlace): GizmoRing | null {
  const gizmo = gizmoOf(sessionOptionsOf(look.session));
  const shown = look.evaluations.selected();
  if (!gizmo || !shown) return null;
  const view = overlayViewAt(look, place);
  const rings = gizmoRings(shown, view, gizmo);
  const lines = gizmoLines(rings, gizmo);
  const id: HandleId | null = pickOverlay(lines, view, pixelsAt(view, place), place.tolerance);
  return rings.find((ring) => ring.id === id) ?? null;
}
