import { computed, effect } from '@preact/signals-core';
import { addPassBefore } from './add-pass.ts';
import { type InspectedPlace, inspectionShapes } from './inspection-shapes.ts';
import { overlayDrawer, overlayViewOf } from './passes/overlay.ts';
import type { Viewer } from './viewer.ts';

const shown = new WeakSet<Viewer>();

/**
 * Shows how methods reach a vertex, from now on.
 *
 * @param read returns what is shown, and subscribes to it
 */
export function showInspection(viewer: Viewer, read: () => readonly InspectedPlace[]): void {
  if (shown.has(viewer)) return;
  shown.add(viewer);
  const places = computed(read);
  addPassBefore(viewer, 'overlay', {
    id: 'inspection',
    isShown: ({ showOverlay }) => showOverlay && places.value.length > 0,
    create: overlayDrawer((frame, cssScale) =>
      inspectionShapes(places.peek(), overlayViewOf(frame, cssScale)),
    ),
  });
  effect(() => {
    if (places.value.length > 0) viewer.requestFrame();
  });
}
