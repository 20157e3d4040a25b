import type { HandleId } from '../document/session.ts';
import { overlayViewAt, pixelsAt } from '../view/overlay-place.ts';
import { pickOverlay } from '../view/overlay.ts';
import { keyShapes, type TrailHandle, trailHandles } from '../view/trail-shapes.ts';
import { showTrails } from '../view/trails.ts';
import { dragTrailKey } from './drag-trail-key.ts';
import type { Looking, Telling } from './editor.ts';
import { showHoveredHandle } from './hover.ts';
import type { TrailKeys } from './trail-keys-shown.ts';
import type { ToolPlace } from './tool.ts';

/** Shows trails from now on, and returns what the pointer can do with them. */
export function createTrailKeys(editor: Looking & Telling): TrailKeys {
  const { viewer, store, session } = editor;
  const { trails, moments } = showTrails(viewer, store, session);

  return {
    at: (place): HandleId | null => handleAt(place)?.id ?? null,
    press(place) {
      const handle = handleAt(place);
      if (!handle) return null;
      showHoveredHandle(editor, handle.id);
      return dragTrailKey(editor, moments, place, handle);
    },
  };

  function handleAt(place: ToolPlace): TrailHandle | undefined {
    if (session.playing.peek()) return undefined;
    const handles = trailHandles(trails.peek());
    if (handles.length === 0) return undefined;
    const view = overlayViewAt(editor, place);
    const shapes = handles.flatMap((handle) => keyShapes(handle, view, false));
    const id = pickOverlay(shapes, view, pixelsAt(view, place), place.tolerance / 2);
    return handles.find((handle) => handle.id === id);
  }
}
