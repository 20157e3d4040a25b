import { keyedActor } from '../document/keying.ts';
import type { KeyedThings } from '../document/keying-targets.ts';
import { keyPlace } from '../document/key-time.ts';
import { type Actor, actorById, type Scene } from '../document/scene.ts';
import type { Session } from '../document/session.ts';
import type { Store } from '../document/store.ts';
import type { Evaluations } from './evaluations.ts';
import { differences, isMoved } from './hold-edits.ts';
import { shownState } from './shown-state.ts';

/**
 * Keys what a gesture edits when it ends, within its step of undo, while the session says so. An
 * edit of a character without a bound clip binds one, and makes it if there is none. The playhead
 * goes to the frame at which the keys are.
 */
export function keyByThemselves(store: Store, session: Session, evaluations: Evaluations): void {
  let begun: Scene = store.scene.peek();
  store.completions.push((before) => {
    begun = before;
    return (edited) => edited;
  });
  const { settle } = store;
  store.settle = (edited) => {
    const scene = settle(edited);
    if (!session.autoKey.peek()) return scene;
    const actors = scene.actors.map((actor) => {
      const old = actorById(begun, actor.id);
      const what = old && editedOf(old, actor);
      if (!what) return actor;
      const shown = shownState(evaluations.of(actor));
      const place = keyPlace(scene, session, actor);
      session.clipTime.value = place.time;
      return keyedActor(actor, place.clip, place.time, shown, what);
    });
    return { ...scene, actors };
  };
}

/** What a gesture has edited and is not keyed, or null if nothing. */
function editedOf(old: Actor, actor: Actor): KeyedThings | null {
  if (actor.character !== old.character || actor.clips !== old.clips) return null;
  if (actor.clip !== null) return actor.unkeyed === old.unkeyed ? null : actor.unkeyed;
  if (old.clip !== null) return null;
  const what = {
    values: differences(actor.q, old.q),
    morphs: differences(actor.morphWeights, old.morphWeights),
    pins: actor.pins.filter((pin) => isMoved(pin, old.pins)).map(({ joint }) => joint),
  };
  return what.values.length + what.morphs.length + what.pins.length > 0 ? what : null;
}
