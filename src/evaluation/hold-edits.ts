import { sameValue } from '../core/same-value.ts';
import { type Actor, actorById, type ActorId, type Scene } from '../document/scene.ts';
import type { Session } from '../document/session.ts';
import type { Store } from '../document/store.ts';
import type { Pin } from '../posing/pins/pin.ts';
import type { Unkeyed } from '../posing/unkeyed.ts';
import type { Evaluations } from './evaluations.ts';

/** What an actor with a bound clip shows when a gesture begins. */
interface Shown {
  readonly q: Float64Array;
  readonly morphWeights: Float64Array;
  readonly pins: readonly Pin[];
}

/**
 * Lets every gesture that edits an actor with a bound clip mark what it changes as unkeyed, so that
 * it shows over the clip.
 */
export function holdEdits(store: Store, session: Session, evaluations: Evaluations): void {
  store.completions.push((before) => {
    const time = session.clipTime.peek();
    const shown = new Map<ActorId, Shown>();
    for (const actor of before.actors) {
      if (actor.clip === null) continue;
      const evaluation = evaluations.of(actor);
      shown.set(actor.id, { ...evaluation.snapshot(), pins: evaluation.pins });
    }
    return (edited) => (shown.size === 0 ? edited : held(before, edited, shown, time));
  });
}

function held(
  before: Scene,
  edited: Scene,
  shown: ReadonlyMap<ActorId, Shown>,
  time: number,
): Scene {
  const actors = edited.actors.map((actor) => {
    const [old, seen] = [actorById(before, actor.id), shown.get(actor.id)];
    if (!old || !seen || old === actor || actor.clip === null) return actor;
    if (actor.character !== old.character || actor.clips !== old.clips) return actor;
    const unkeyed = withEdits(old, actor, seen, time);
    return unkeyed ? { ...actor, unkeyed } : actor;
  });
  return { ...edited, actors };
}

/** Returns what is unkeyed after an edit, or undefined if it changed nothing that a clip moves. */
function withEdits(old: Actor, actor: Actor, shown: Shown, time: number): Unkeyed | undefined {
  const values = actor.q === old.q ? [] : differences(actor.q, shown.q);
  const morphs =
    actor.morphWeights === old.morphWeights
      ? []
      : differences(actor.morphWeights, shown.morphWeights);
  const pins = actor.pins
    .filter((pin) => !old.pins.includes(pin) && isMoved(pin, shown.pins))
    .map(({ joint }) => joint);
  if (values.length + morphs.length + pins.length === 0) return undefined;
  const before = old.unkeyed ?? { values: [], morphs: [], pins: [] };
  return {
    time,
    values: united(before.values, values),
    morphs: united(before.morphs, morphs),
    pins: united(before.pins, pins),
  };
}

/** The indices at which two lists differ, bit by bit. */
export function differences(edited: Float64Array, shown: Float64Array): number[] {
  const found: number[] = [];
  edited.forEach((value, at) => {
    if (!Object.is(value, shown[at])) found.push(at);
  });
  return found;
}

/** Whether a pin that was there before holds another place or has another weight. */
export function isMoved({ joint, place, weight }: Pin, shown: readonly Pin[]): boolean {
  const seen = shown.find((pin) => pin.joint === joint);
  return seen !== undefined && !sameValue([place, weight], [seen.place, seen.weight]);
}

function united(a: readonly number[], b: readonly number[]): readonly number[] {
  return [...new Set([...a, ...b])].sort((first, second) => first - second);
}
