import type { Actor, ActorId, Scene } from './scene.ts';

/** Whether an actor's pins follow another one, directly or through others. */
export function follows(
  { actors }: Pick<Scene, 'actors'>,
  follower: ActorId,
  followed: ActorId,
): boolean {
  if (follower === followed) return true;
  const pins = actors.find(({ id }) => id === follower)?.pins ?? [];
  return pins.some((pin) => pin.follows && follows({ actors }, pin.follows.actor, followed));
}

/**
 * Returns actors of which none follows itself, directly or through others: in their order, a pin
 * that would close a circle becomes one that holds a place.
 */
export function withoutCircles(actors: readonly Actor[]): Actor[] {
  let kept: Actor[] = actors.map((actor) => ({ ...actor, pins: [] }));
  for (const [at, actor] of actors.entries()) {
    const pins = actor.pins.map((pin) =>
      pin.follows && follows({ actors: kept }, pin.follows.actor, actor.id)
        ? { ...pin, follows: null }
        : pin,
    );
    kept = kept.with(at, pins.length > 0 ? { ...actor, pins } : actor);
  }
  return kept;
}
