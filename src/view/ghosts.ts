import { effect, signal } from '@preact/signals-core';
import { motionViewOf } from '../document/motion-view.ts';
import { boundClip } from '../document/scene.ts';
import { selectedActor } from '../document/selected-actor.ts';
import type { Session } from '../document/session.ts';
import type { Store } from '../document/store.ts';
import type { Evaluation } from '../evaluation/evaluation.ts';
import { ghostTimes } from '../evaluation/ghost-times.ts';
import { Moments } from '../evaluation/moments.ts';
import { timeInClip } from '../posing/playhead.ts';
import { addPassBefore } from './add-pass.ts';
import { ghostsPass } from './passes/ghosts.ts';
import { afterColor, beforeColor } from './trail-shapes.ts';
import type { Viewer } from './viewer.ts';

/** A copy of a character at another moment. */
export interface Ghost {
  readonly evaluation: Evaluation;
  /** In linear light. */
  readonly color: readonly number[];
  readonly opacity: number;
}

/** The opacity of the ghosts that are nearest to the present. */
const nearest = 0.6;

/** Shows ghosts of the selected character whenever the session asks for them. */
export function showGhosts(viewer: Viewer, store: Store, session: Session): void {
  const moments = new Moments(store, session, viewer.evaluations);
  const { ghosts } = motionViewOf(session);
  const shown = signal<readonly Ghost[]>([]);
  addPassBefore(viewer, 'skeleton', ghostsPass(viewer, shown));
  effect(() => {
    const actor = selectedActor(store, session);
    const clip = actor && boundClip(actor);
    const settings = ghosts.value;
    const mode = session.playMode.value;
    const isShown = settings.isOn && (settings.whilePlaying || !session.playing.value);
    const time = clip ? timeInClip(clip, session.clipTime.value, mode) : 0;
    const times = clip && isShown ? ghostTimes(clip, time, settings, mode) : [];
    const next = times.map(({ time: at, rank }): Ghost => {
      const count = rank < 0 ? settings.before : settings.after;
      const far = count > 1 ? (Math.abs(rank) - 1) / (count - 1) : 0;
      return {
        evaluation: moments.at(`ghost ${rank}`, actor!, at),
        color: rank < 0 ? beforeColor : afterColor,
        opacity: nearest * (1 - settings.fade * far),
      };
    });
    moments.keepOnly(times.map(({ rank }) => `ghost ${rank}`));
    // The renderer keeps the objects on the GPU of what is held, and disposes of those of the rest.
    for (const { evaluation } of shown.peek()) viewer.held.delete(evaluation);
    for (const { evaluation } of next) viewer.held.add(evaluation);
    if (next.length + shown.peek().length > 0) viewer.requestFrame();
    shown.value = next;
  });
}
