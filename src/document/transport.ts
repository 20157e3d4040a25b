import { type Clip, clipFor } from '../core/motion/clip.ts';
import type { ClipParts } from '../core/motion/clip-parts.ts';
import { advance } from '../posing/playhead.ts';
import { releaseClip } from './clip-edits.ts';
import { bindClip } from './edits.ts';
import { dropUnkeyed, droppedCount } from './keying-drop.ts';
import type { ShownState } from './keying-targets.ts';
import { snapped } from './key-time.ts';
import { type Actor, boundClip } from './scene.ts';
import { selectedActor } from './selected-actor.ts';
import type { Session } from './session.ts';
import type { Store } from './store.ts';

/** In seconds. */
export interface TimeRange {
  readonly start: number;
  readonly end: number;
}

/**
 * Plays, pauses and seeks the clips of the selected character. Only what it drops or releases is a
 * step of undo.
 */
export class Transport {
  private readonly store: Store;
  private readonly session: Session;
  private readonly tell: (message: string) => void;

  /** @param tell shows a message to the user */
  constructor(store: Store, session: Session, tell: (message: string) => void = () => undefined) {
    this.store = store;
    this.session = session;
    this.tell = tell;
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

  /**
   * The range that is played: the work range, as far as clips have it, or else all that bound clips
   * have; undefined if no clip is bound.
   */
  get range(): TimeRange | undefined {
    const { bound } = this;
    if (bound.length === 0) return undefined;
    const start = Math.min(...bound.map((clip) => clip.start));
    const end = Math.max(...bound.map((clip) => clip.end));
    const [from, to] = this.session.workRange.value ?? [start, end];
    const inside = { start: Math.max(from, start), end: Math.min(to, end) };
    return inside.end > inside.start ? inside : { start, end };
  }

  togglePlay(): void {
    if (this.session.playing.value && (this.isBound || !this.clip)) {
      this.session.playing.value = false;
      return;
    }
    if (this.clip) this.play(() => this.bind());
  }

  /** Plays a clip of every character that has one: the bound one, else the one that is chosen. */
  playAll(): void {
    const { state } = this;
    this.play(() => {
      for (const { id, clip, clips } of this.store.scene.value.actors) {
        if (clip !== null || clips.length === 0) continue;
        this.store.amend(bindClip(id, id === state?.id ? this.clipIndex : 0));
      }
    });
  }

  /**
   * Shows the clip's pose at a time, or at the nearest frame if times snap, and pauses. Times beyond
   * all clips are shown only where playback goes on there too; elsewhere clips repeat.
   */
  seek(time: number): void {
    const { session, clip } = this;
    if (!clip) return;
    const isEnd = time === clip.start || time === clip.end;
    const at = isEnd ? time : snapped(session, time, clip.fps);
    this.goTo(session.playMode.value === 'go on' ? at : this.within(at));
  }

  /** Shows the clip's pose at exactly this time, and pauses. */
  goTo(time: number): void {
    const { session, clip } = this;
    if (!clip) return;
    if (time !== session.clipTime.value) this.leave();
    this.bind();
    session.playing.value = false;
    session.clipTime.value = time;
  }

  /** Goes on or back by a frame, within the range that is played. */
  step(direction: 1 | -1): void {
    const { clip, session } = this;
    if (!clip) return;
    const frame = session.clipTime.value * clip.fps;
    const near = 1e-6; // of a frame
    const next = direction > 0 ? Math.floor(frame + near) + 1 : Math.ceil(frame - near) - 1;
    const time = (session.snapsToFrames.value ? next : frame + direction) / clip.fps;
    const { start, end } = this.range ?? clip;
    this.goTo(Math.min(Math.max(time, start), end));
  }

  /** Chooses another clip of the character, from its start. */
  choose(index: number): void {
    const { session, state } = this;
    if (state && state.clip !== null && state.clip !== index) this.leave();
    session.clipIndex.value = index;
    if (state && state.clip !== null) this.store.amend(bindClip(state.id, index));
    session.workRange.value = null;
    session.clipTime.value = this.clip?.start ?? 0;
  }

  /**
   * Unbinds the clip, so that the character keeps what it shows as its own. It is a step of undo.
   *
   * @param shown what the character shows
   */
  release(shown: ShownState): void {
    const { state } = this;
    this.session.playing.value = false;
    if (state && state.clip !== null) this.store.dispatch(releaseClip(state, shown));
  }

  /** Advances playback by an interval of real time. */
  pass(seconds: number): void {
    const { session, range } = this;
    if (!range) {
      session.playing.value = false;
      return;
    }
    const from = { time: session.clipTime.value, forward: session.playForward.value };
    const moved = advance(range, from, seconds * session.playSpeed.value, session.playMode.value);
    session.playForward.value = moved.forward;
    session.clipTime.value = moved.time;
    if (moved.ended) session.playing.value = false;
  }

  private get state(): Actor | undefined {
    return selectedActor(this.store, this.session);
  }

  /** The nearest time that a clip of the scene has. */
  private within(time: number): number {
    const { clip } = this;
    const all = [...this.bound, ...(clip ? [clip] : [])];
    const start = Math.min(...all.map((each) => each.start));
    const end = Math.max(...all.map((each) => each.end));
    return Math.min(Math.max(time, start), end);
  }

  private get bound(): readonly ClipParts[] {
    return this.store.scene.value.actors.flatMap((actor) => boundClip(actor) ?? []);
  }

  /** @param bind binds the clips that are to be played */
  private play(bind: () => void): void {
    const { session } = this;
    this.leave();
    bind();
    const { range } = this;
    if (!range) return;
    const { clipTime } = session;
    const isOver = session.playMode.value === 'once' && clipTime.value >= range.end;
    const isBeside = session.workRange.value !== null && !isInside(range, clipTime.value);
    if (isOver || isBeside) clipTime.value = range.start;
    session.playing.value = true;
  }

  /** Leaves the moment at which values are unkeyed: they are dropped, as a step of undo. */
  private leave(): void {
    const { store, tell } = this;
    const scene = store.scene.peek();
    if (scene.actors.every(({ unkeyed }) => unkeyed === null)) return;
    const count = droppedCount(scene);
    if (count === 0) {
      store.amend(dropUnkeyed);
      return;
    }
    store.dispatch(dropUnkeyed);
    const brings =
      count === 1 ? 'value dropped; Undo brings it back' : 'values dropped; Undo brings them back';
    tell(`${count} unkeyed ${brings}`);
  }

  private bind(): void {
    const { state, clip } = this;
    if (state && clip && state.clip === null) {
      this.store.amend(bindClip(state.id, this.clipIndex));
    }
  }
}

function isInside({ start, end }: TimeRange, time: number): boolean {
  return time >= start && time <= end;
}
