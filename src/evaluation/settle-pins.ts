import { sameValue } from '../core/same-value.ts';
import { type Actor, actorById, type Scene } from '../document/scene.ts';
import type { Pin } from '../posing/pins/pin.ts';
import { pinTarget } from '../posing/pins/pin-target.ts';
import type { Evaluation } from './evaluation.ts';
import type { Evaluations } from './evaluations.ts';

/**
 * Writes what pins do into a scene: the pose that is shown becomes the character's own, unless a
 * clip determines it, and pins that follow remember where they are. A pin whose followed joint is
 * gone stays there. Since pins leave a pose in which they hold as it is, nothing moves.
 */
export function settlePins(scene: Scene, evaluations: Evaluations): Scene {
  const actors = scene.actors.map((actor) =>
    actor.pins.length === 0 ? actor : settled(scene, actor, evaluations.of(actor)),
  );
  return actors.every((actor, i) => actor === scene.actors[i]) ? scene : { ...scene, actors };
}

function settled(scene: Scene, actor: Actor, { followed, poseToEdit }: Evaluation): Actor {
  const pins = actor.pins.map((pin, at): Pin => {
    const { place, rotation } = pinTarget(pin, followed, at);
    const other = pin.follows && actorById(scene, pin.follows.actor);
    const isThere = other && pin.follows.joint < other.character.skeleton.jointCount;
    return { ...pin, place, rotation, follows: isThere ? pin.follows : null };
  });
  const q = actor.clip === null ? poseToEdit.q.slice() : actor.q;
  const after = { ...actor, pins, q };
  return sameValue([pins, q], [actor.pins, actor.q]) ? actor : after;
}
