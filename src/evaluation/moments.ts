import { type Actor, type ActorId, boundClip } from '../document/scene.ts';
import type { Session } from '../document/session.ts';
import type { Store } from '../document/store.ts';
import { timeInClip } from '../posing/playhead.ts';
import type { Evaluation, StillEvaluation } from './evaluation.ts';
import type { Evaluations } from './evaluations.ts';
import { followedJoints } from './followed-joints.ts';

/**
 * Characters at other moments than the one that is shown, such as ghosts and the frames of a trail.
 * Each has an evaluation of its own, in the pool of the shown ones. Whoever creates it disposes of
 * it.
 */
export class Moments {
  private readonly store: Store;
  private readonly session: Session;
  private readonly evaluations: Evaluations;
  private readonly slots = new Map<string, Map<ActorId, StillEvaluation>>();

  constructor(store: Store, session: Session, evaluations: Evaluations) {
    this.store = store;
    this.session = session;
    this.evaluations = evaluations;
  }

  /**
   * Returns the actor as its clip has it at a time of the scene, without what is not keyed.
   *
   * @param slot names the moment; the evaluation moves when another time is asked for by this name
   * @param time in seconds
   */
  at(slot: string, actor: Actor, time: number): Evaluation {
    let held = this.slots.get(slot);
    if (!held) this.slots.set(slot, (held = new Map<ActorId, StillEvaluation>()));
    let evaluation = held.get(actor.id);
    if (evaluation?.state.character !== actor.character) {
      evaluation?.dispose();
      held.set(actor.id, (evaluation = this.evaluations.of(actor).still()));
    }
    const keyed = actor.unkeyed ? { ...actor, unkeyed: null } : actor;
    const clip = boundClip(actor);
    const inClip = clip ? timeInClip(clip, time, this.session.playMode.peek()) : 0;
    return evaluation.evaluate(keyed, inClip, this.followedBy(slot, actor, time));
  }

  /** Disposes of the evaluations of all other slots. */
  keepOnly(used: readonly string[]): void {
    for (const [slot, held] of this.slots) {
      if (used.includes(slot)) continue;
      for (const evaluation of held.values()) evaluation.dispose();
      this.slots.delete(slot);
    }
  }

  /** What an actor's pins follow, at the same time. */
  private followedBy(slot: string, actor: Actor, time: number): Float64Array | null {
    if (!actor.pins.some(({ follows }) => follows)) return null;
    const scene = this.store.scene.peek();
    return followedJoints(actor, scene, (other) => this.at(slot, other, time));
  }
}
