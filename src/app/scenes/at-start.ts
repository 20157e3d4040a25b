import { keptValue } from '../../ui/kept.ts';

/** The key under which the browser remembers the id of the scene that was kept last. */
export const keptMarker = 'kept scene';

/** Whether the page's address carries a scene. What opens it is loaded only then. */
export function hasLink(): boolean {
  return location.hash.startsWith('#s=');
}

/** Whether a scene may be there to be restored. What restores it is loaded only then. */
export function mayRestore(): boolean {
  return keptValue(keptMarker) !== '';
}
