import type { HandleId, Session } from '../document/session.ts';
import type { ToolDrag, ToolPlace } from './tool.ts';

/** What the pointer can do with trails, once they are there. */
export interface TrailKeys {
  /** The id of the key of a trail at a place of the view, or null. */
  at(place: ToolPlace): HandleId | null;
  /** Takes hold of that key. */
  press(place: ToolPlace): ToolDrag | null;
}

const shown = new WeakMap<Session, TrailKeys>();

/** The keys of trails, or nothing before trails were first shown. */
export function trailKeysOf(session: Session): TrailKeys | undefined {
  return shown.get(session);
}

export function showTrailKeys(session: Session, keys: TrailKeys): void {
  shown.set(session, keys);
}
