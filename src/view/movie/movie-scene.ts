import { type Signal, signal } from '@preact/signals-core';
import { emptyScene, type Scene } from '../../document/scene.ts';
import { Session } from '../../document/session.ts';
import type { Evaluation } from '../../evaluation/evaluation.ts';
import { Evaluations, type Overrides } from '../../evaluation/evaluations.ts';
import type { HeldMoment } from '../picture/held-moment.ts';
import { type ViewOptions, viewOptionsOf } from '../view-options.ts';
import type { Viewer } from '../viewer.ts';

/**
 * A scene as it was at one time, with a time of its own, so that neither the user's edits change the
 * movie nor the movie changes what the page shows. It keeps its objects on the GPU from frame to
 * frame until it is released.
 */
export class MovieScene {
  /** How the page viewed the scene. */
  readonly options: Partial<ViewOptions>;
  readonly evaluations: Evaluations;
  private readonly viewer: Viewer;
  readonly scene: Signal<Scene>;
  private readonly own = new Session();
  private readonly held = new Set<Evaluation>();

  /** @param session of the page, whose way to view the scene and to play clips stays as it is now */
  constructor(viewer: Viewer, scene: Scene, session: Session) {
    this.viewer = viewer;
    this.scene = signal(scene);
    this.own.playMode.value = session.playMode.peek();
    this.own.selectedActorId.value = session.selectedActorId.peek();
    this.evaluations = new Evaluations(this, this.own, viewer.evaluations.pool.kernels);
    this.options = { ...viewOptionsOf(session, scene), showOverlay: false };
  }

  /** Shows another time of the clips, in seconds. */
  seek(time: number): void {
    this.own.clipTime.value = time;
  }

  /** What is visible at its time, which stays its own. */
  readonly hold = (overrides?: Overrides): HeldMoment => {
    const shown = this.evaluations.visible(overrides);
    for (const evaluation of shown) {
      this.held.add(evaluation);
      this.viewer.held.add(evaluation);
    }
    // Drawing of any kind empties the canvas.
    this.viewer.requestFrame();
    return { shown, release: () => undefined };
  };

  release(): void {
    for (const evaluation of this.held) this.viewer.held.delete(evaluation);
    this.scene.value = emptyScene;
    this.evaluations.keepOnly([]);
    this.viewer.requestFrame();
  }
}
