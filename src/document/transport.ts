import { type Clip, clipFor } from '../core/motion/clip.ts';
import type { ClipParts } from '../core/motion/clip-parts.ts';
import { advance } from '../posing/playhead.ts';
import { bindClip } from './edits.ts';
import { type Actor, boundClip } from './scene.ts';
import { selectedActor } from './selected-actor.ts';
import type { Session } from './session.ts';
import type { Store } from './store.ts';

/** Plays, pauses and seeks the clips of the selected character. None of this is a step of undo. */
export class Transport {
  private readonly store: Store;
  private readonly session: Session;

  constructor(store: Store, session: Session) {
    this.store = store;
    this.session = session;
  }

  /**
   * Which of the character's clips is bound, or would be bound by Play. The last choice may belong
   * to a character that undo has removed; then it is the first clip.
   */
  get clipIndex(): number {
    const { state } = this;
    const chosen = this.session.clipIndex.value;
    return state?.clip ?? (state?.clips[chosen] ? chosen : 0);
  }

  /** The clip at `clipIndex`, or undefined if the character has none. */
  get clip(): Clip | undefined {
    const { state } = this;
    const parts = state?.clips[this.clipIndex];
    return parts && clipFor(parts, state.character);
  }

  get isBound(): boolean {
    return (this.state?.clip ?? null) !== null;
  }

  togglePlay(): void {
    const { playing, playMode, clipTime } = this.session;
    if (playing.value && this.isBound) {
      playing.value = false;
      return;
    }
    const clip = this.bind();
    if (!clip) return;
    if (playMode.value === 'once' && clipTime.value >= clip.end) clipTime.value = clip.start;
    playing.value = true;
  }

  /** Shows the clip's pose at a time, and pauses. */
  seek(time: number): void {
    if (!this.bind()) return;
    this.session.playing.value = false;
    this.session.clipTime.value = time;
  }

  step(direction: 1 | -1): void {
    const { clip } = this;
    if (!clip) return;
    const time = this.session.clipTime.value + direction / clip.fps;
    this.seek(Math.min(Math.max(time, clip.start), clip.end));
  }

  /** Chooses another clip of the character, from its start. */
  choose(index: number): void {
    const { session, state } = this;
    session.clipIndex.value = index;
    session.clipTime.value = this.clip?.start ?? 0;
    if (state && state.clip !== null) this.store.amend(bindClip(state.id, index));
    session.clipTime.value = this.clip?.start ?? 0;
  }

  /** Unbinds the clip, so that the character shows its own pose. */
  release(): void {
    const { state } = this;
    this.session.playing.value = false;
    if (state && state.clip !== null) this.store.amend(bindClip(state.id, null));
  }

  /** Advances playback by an interval of real time. */
  pass(seconds: number): void {
    const { session } = this;
    const clip = this.isBound ? this.clip : this.otherBoundClip;
    if (!clip) {
      session.playing.value = false;
      return;
    }
    const from = { time: session.clipTime.value, forward: session.playForward.value };
    const moved = advance(clip, from, seconds * session.playSpeed.value, session.playMode.value);
    session.playForward.value = moved.forward;
    session.clipTime.value = moved.time;
    if (moved.ended) session.playing.value = false;
  }

  /** The clip of an actor that plays while another actor is selected. */
  private get otherBoundClip(): ClipParts | undefined {
    const bound = this.store.scene.value.actors.find(({ clip }) => clip !== null);
    return bound && boundClip(bound);
  }

  private get state(): Actor | undefined {
    return selectedActor(this.store, this.session);
  }

  private bind(): Clip | undefined {
    const { state, clip } = this;
    if (state && clip && state.clip === null) {
      this.store.amend(bindClip(state.id, this.clipIndex));
    }
    return clip;
  }
}
