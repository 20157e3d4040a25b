import { pickOverlay } from './overlay.ts';
import { overlayViewAt, pixelsAt } from './overlay-place.ts';
import type { Looking, PickPlace } from './pick.ts';
import { type PinHandle, pinHandles, pinShapes } from './pin-handles.ts';

/** Returns the pin whose diamond is at a place of the view, or null. */
export function pinAt(look: Looking, place: PickPlace): PinHandle | null {
  const { evaluations, session } = look;
  if (session.playing.value) return null;
  const handles = evaluations.visible().flatMap(pinHandles);
  if (handles.length === 0) return null;
  const view = overlayViewAt(look, place);
  // What joins a joint with a place out of reach is not picked.
  const diamonds = pinShapes(
    handles.map((handle) => ({ ...handle, miss: 0 })),
    view,
    null,
  );
  const id = pickOverlay(diamonds, view, pixelsAt(view, place), place.tolerance / 2);
  return handles.find((handle) => handle.id === id) ?? null;
}
