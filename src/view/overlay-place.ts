import type { OverlayView } from './overlay.ts';
import type { Looking, PickPlace } from './pick.ts';

/** Returns the view at a place as the overlay sees it; its pixels are CSS pixels. */
export function overlayViewAt({ viewer }: Looking, { viewHeight }: PickPlace): OverlayView {
  const width = viewHeight * viewer.aspect;
  return { camera: viewer.viewCamera.value, width, height: viewHeight };
}

/** The place in pixels from the view's middle, y up. */
export function pixelsAt(view: OverlayView, { x, y }: PickPlace): [number, number] {
  return [(x * view.width) / 2, (y * view.height) / 2];
}
