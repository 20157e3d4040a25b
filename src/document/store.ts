import { batch, computed, type ReadonlySignal, signal } from '@preact/signals-core';
import type { Edit } from './edits.ts';
import { emptyScene, sameScene, type Scene } from './scene.ts';
import {
  emptyHistory,
  type History,
  type HistoryEntry,
  record,
  replacePresent,
  stepBack,
  stepForward,
} from './history.ts';

/** A change that is still under way, a slider or bone drag: one step of undo in the end. */
export interface Gesture {
  /** False once committed or canceled, by whoever. */
  readonly isOpen: boolean;
  /** Shows the outcome of the edit on the scene as it was when the gesture began. */
  preview(edit: Edit): void;
  commit(): void;
  /** Restores the scene of the beginning, bit for bit. */
  cancel(): void;
  /** Takes back what was committed, as if it had never been; not where something came after it. */
  withdraw(): void;
}

/** Holds the scene and its history; every change goes through here. */
export class Store {
  private readonly current = signal<Scene>(emptyScene);
  private readonly history = signal<History>(emptyHistory);
  private readonly onChange: (before: Scene, after: Scene) => void;
  private open: Gesture | null = null;

  readonly scene: ReadonlySignal<Scene> = this.current;
  /** What Undo and Redo would do, or null. */
  readonly undoLabel = computed(() => this.history.value.past.at(-1)?.label ?? null);
  readonly redoLabel = computed(() => this.history.value.future.at(-1)?.label ?? null);

  /** @param onChange runs with every change, undo and redo too, before anything that follows it */
  constructor(onChange: (before: Scene, after: Scene) => void = () => undefined) {
    this.onChange = onChange;
  }

  dispatch(edit: Edit): void {
    const gesture = this.begin(edit.label);
    gesture.preview(edit);
    gesture.commit();
  }

  /**
   * Changes the scene without a step of undo, for what makes nothing of the user's: which clip plays. The
   * steps on both sides then lead to the changed scene, so that undo and redo pass through what was shown.
   */
  amend(edit: Edit): void {
    this.open?.commit();
    const amended = edit.apply(this.current.value);
    this.show(amended);
    this.history.value = replacePresent(this.history.value, amended);
  }

  /** Begins a gesture; one that is still open is committed first. */
  begin(label: string): Gesture {
    this.open?.commit();
    const before = this.current.value;
    const isOpen = (): boolean => this.open === gesture;
    let entry: HistoryEntry | undefined;
    const gesture: Gesture = {
      get isOpen() {
        return isOpen();
      },
      preview: (edit) => {
        if (isOpen()) this.show(edit.apply(before));
      },
      commit: () => {
        if (!isOpen()) return;
        this.open = null;
        const after = this.current.value;
        // What changed nothing is no step, and leaves the very scene of before.
        if (sameScene(before, after)) {
          this.show(before);
          return;
        }
        // An empty page is nothing to go back to: the first character opens without a step of undo.
        const isFirst = before.actors.length === 0 && this.history.value.past.length === 0;
        if (isFirst) return;
        entry = { label, before, after };
        this.history.value = record(this.history.value, entry);
      },
      cancel: () => {
        if (!isOpen()) return;
        this.open = null;
        this.show(before);
      },
      withdraw: () => {
        const { past } = this.history.value;
        if (!entry || past.at(-1) !== entry) return;
        this.show(before);
        this.history.value = { past: past.slice(0, -1), future: [] };
      },
    };
    this.open = gesture;
    return gesture;
  }

  /** Cancels an open gesture; true where there was one. */
  cancelGesture(): boolean {
    const gesture = this.open;
    gesture?.cancel();
    return gesture !== null;
  }

  /** Takes back the last step; gives what it was, or null where there was none. */
  undo(): string | null {
    this.open?.commit();
    const entry = this.history.value.past.at(-1);
    if (!entry) return null;
    this.show(entry.before);
    this.history.value = stepBack(this.history.value);
    return entry.label;
  }

  /** Does the step again that was taken back last; gives what it was, or null where there was none. */
  redo(): string | null {
    this.open?.commit();
    const entry = this.history.value.future.at(-1);
    if (!entry) return null;
    this.show(entry.after);
    this.history.value = stepForward(this.history.value);
    return entry.label;
  }

  /** In one batch, so that nobody meets a session that does not fit the scene. */
  private show(after: Scene): void {
    const before = this.current.value;
    if (after === before) return;
    batch(() => {
      this.current.value = after;
      this.onChange(before, after);
    });
  }
}
