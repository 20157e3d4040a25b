import { type Actor, boundClip } from '../document/scene.ts';
import { selectedActor } from '../document/selected-actor.ts';
import type { Session } from '../document/session.ts';
import type { Store } from '../document/store.ts';
import type { KernelId } from '../skinning/method.ts';
import { type Deformation, deformationOf, kernelOf } from '../skinning/registry.ts';
import { timeInClip } from '../posing/playhead.ts';
import type { Evaluation } from './evaluation.ts';
import { EvaluationPool } from './evaluation-pool.ts';
import { Evaluator } from './evaluator.ts';
import { Kernels } from './kernels.ts';

/** What differs from the scene for every actor, for views beside the usual one. */
export interface Overrides {
  readonly deformation?: Partial<Deformation>;
}

/**
 * The scene as it is shown at the session's time. It has one evaluator per character, which view,
 * picking, panels, pictures and exports share. Reading subscribes to the scene and the time.
 */
export class Evaluations {
  private readonly store: Pick<Store, 'scene'>;
  private readonly session: Session;
  private readonly evaluators = new Map<string, Evaluator>();
  readonly pool: EvaluationPool;

  constructor(store: Pick<Store, 'scene'>, session: Session, kernels = new Kernels()) {
    this.pool = new EvaluationPool(kernels);
    this.store = store;
    this.session = session;
  }

  /**
   * Resolves when nothing is pending for the actors, under their own kernels and under these. It
   * rejects if one of the kernels can't be loaded.
   */
  async settled(beside: readonly KernelId[] = []): Promise<void> {
    const { kernels } = this.pool;
    const shown = this.store.scene
      .peek()
      .actors.flatMap((actor) => [
        actor,
        ...beside.map((id) => ({ ...actor, ...deformationOf(id) })),
      ]);
    await Promise.all([
      ...shown.map((actor) => kernels.loadFor(actor)),
      ...beside.map((id) => kernels.load(id)),
    ]);
    await kernels.settled();
  }

  /** Loads kernels before they are needed. Linear blend replaces one that can't be loaded. */
  async prepare(ids: readonly KernelId[]): Promise<void> {
    await Promise.allSettled(ids.map((id) => this.pool.kernels.load(id)));
  }

  /** The evaluations of all actors. */
  all(overrides?: Overrides): readonly Evaluation[] {
    return this.store.scene.value.actors.map((actor) => this.of(actor, overrides));
  }

  /** The evaluations of the actors that are not hidden. */
  visible(overrides?: Overrides): readonly Evaluation[] {
    return this.all(overrides).filter(({ state }) => state.look.visible);
  }

  /** Disposes of the evaluators of actors and overrides that are no longer shown. */
  keepOnly(shown: readonly Evaluation[]): void {
    for (const [key, evaluator] of this.evaluators) {
      const isIn = this.store.scene.value.actors.some(({ id }) => id === evaluator.state.id);
      const isPlain = key === String(evaluator.state.id);
      if (isIn && (isPlain || shown.includes(evaluator))) continue;
      evaluator.dispose();
      this.evaluators.delete(key);
    }
  }

  /** The evaluation of the selected character, if there is one. */
  selected(): Evaluation | undefined {
    const actor = selectedActor(this.store, this.session);
    return actor && this.of(actor);
  }

  /** The evaluation of an actor of the scene. */
  of(actor: Actor, { deformation }: Overrides = {}): Evaluation {
    const shown = deformation ? { ...actor, ...deformation } : actor;
    const key = deformation
      ? `${actor.id} ${kernelOf(shown).id} ${deformation.normalizeWeights}`
      : String(actor.id);
    let evaluator = this.evaluators.get(key);
    if (!evaluator?.fits(shown)) {
      evaluator?.dispose();
      this.evaluators.set(key, (evaluator = new Evaluator(shown, this.pool)));
    }
    const { clipTime, playMode } = this.session;
    const clip = boundClip(actor);
    const time = clip ? timeInClip(clip, clipTime.value, playMode.value) : 0;
    return evaluator.evaluate(shown, time, this.followedBy(actor));
  }

  /** See `PoseContext`. */
  private followedBy(actor: Actor): Float64Array | null {
    if (!actor.pins.some(({ follows }) => follows)) return null;
    const find = this.pool.kernels.followed.value;
    return find ? find(actor, this.store.scene.value, (other) => this.of(other)) : null;
  }
}
