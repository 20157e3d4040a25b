import { type LightHandle, lightHandles, showsLights } from './light-handles.ts';
import { pixelsIn } from './overlay.ts';
import { overlayViewAt, pixelsAt } from './overlay-place.ts';
import type { Looking, PickPlace } from './pick.ts';
import { sessionOptionsOf } from './view-options.ts';

/** A light's disc, in CSS pixels. */
const discReach = 9;

/** Returns the light whose disc is at a place of the view, or null. */
export function lightAt(look: Looking, place: PickPlace): LightHandle | null {
  if (!showsLights(sessionOptionsOf(look.session))) return null;
  const view = overlayViewAt(look, place);
  const [x, y] = pixelsAt(view, place);
  const toPixels = pixelsIn(view);
  const distanceTo = (handle: LightHandle): number => {
    const [handleX, handleY] = toPixels(handle.place);
    return Math.hypot(handleX - x, handleY - y);
  };
  const handles = lightHandles(look.store.scene.value.environment, view);
  const [nearest] = handles.sort((a, b) => distanceTo(a) - distanceTo(b));
  return nearest && distanceTo(nearest) <= discReach + place.tolerance ? nearest : null;
}
