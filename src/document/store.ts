import { batch, computed, type ReadonlySignal, signal } from '@preact/signals-core';
import type { Edit } from './edit.ts';
import { emptyScene, sameScene, type Scene } from './scene.ts';
import {
  emptyHistory,
  type History,
  type HistoryEntry,
  record,
  replacePresent,
  stepTo,
} from './history.ts';

/** A change in progress, such as a slider or bone drag. It becomes one step of undo. */
export interface Gesture {
  /** False after it was committed or canceled, by any code. */
  readonly isOpen: boolean;
  /** Shows the result of the edit on the scene at which the gesture began. */
  preview(edit: Edit): void;
  commit(): void;
  /** Restores the scene at which the gesture began, bit for bit. */
  cancel(): void;
  /** Removes the committed step as if it had never existed, unless another step followed. */
  withdraw(): void;
}

/**
 * Completes what a gesture edits, such as live symmetry. It is called with the scene at which the
 * gesture begins.
 */
export type Completion = (before: Scene) => (edited: Scene) => Scene;

/** Holds the scene and its history. Every change goes through it. */
export class Store {
  private readonly current = signal<Scene>(emptyScene);
  private readonly steps = signal<History>(emptyHistory);
  private readonly onChange: (before: Scene, after: Scene) => void;
  private open: Gesture | null = null;
  /**
   * Returns the scene that a step leads to, from the one that its edit made and that is shown. It
   * changes nothing that can be seen.
   */
  settle = (scene: Scene): Scene => scene;

  readonly scene: ReadonlySignal<Scene> = this.current;
  readonly history: ReadonlySignal<History> = this.steps;
  /** What every gesture's scenes pass through before they are shown, in this order. */
  readonly completions: Completion[] = [];
  /** Whether the scene is somebody's work although no step led to it, as one that was restored. */
  readonly isMade = signal(false);
  /** The labels of the steps that Undo and Redo would apply, or null. */
  readonly undoLabel = computed(() => this.steps.value.past.at(-1)?.label ?? null);
  readonly redoLabel = computed(() => this.steps.value.future.at(-1)?.label ?? null);

  /** @param onChange runs with every change, including undo and redo, before any subscriber */
  constructor(onChange: (before: Scene, after: Scene) => void = () => undefined) {
    this.onChange = onChange;
  }

  /** Whether a gesture is open. */
  get isEditing(): boolean {
    return this.open !== null;
  }

  dispatch(edit: Edit): void {
    const gesture = this.begin(edit.label);
    gesture.preview(edit);
    gesture.commit();
  }

  /**
   * Changes the scene without a step of undo, for changes that are not the user's work, such as
   * which clip plays. The steps on both sides then lead to the changed scene, so that undo and redo
   * pass through what was shown.
   */
  amend(edit: Edit): void {
    this.open?.commit();
    const amended = edit.apply(this.current.value);
    this.show(amended);
    this.steps.value = replacePresent(this.steps.value, amended);
  }

  /** Begins a gesture. If one is still open, it is committed first. */
  begin(label: string): Gesture {
    this.open?.commit();
    const before = this.current.value;
    const complete = this.completions.map((completion) => completion(before));
    const isOpen = (): boolean => this.open === gesture;
    let entry: HistoryEntry | undefined;
    const gesture: Gesture = {
      get isOpen() {
        return isOpen();
      },
      preview: (edit) => {
        if (!isOpen()) return;
        this.show(complete.reduce((scene, each) => each(scene), edit.apply(before)));
      },
      commit: () => {
        if (!isOpen()) return;
        this.open = null;
        this.show(this.settle(this.current.value));
        const after = this.current.value;
        // A gesture without an effect adds no step and restores the identical scene.
        if (sameScene(before, after)) {
          this.show(before);
          return;
        }
        // Returning to an empty page is useless, so the first character opens without a step of
        // undo.
        const isFirst = before.actors.length === 0 && this.steps.value.past.length === 0;
        if (isFirst) return;
        entry = { label, before, after };
        this.steps.value = record(this.steps.value, entry);
      },
      cancel: () => {
        if (!isOpen()) return;
        this.open = null;
        this.show(before);
      },
      withdraw: () => {
        const { past } = this.steps.value;
        if (!entry || past.at(-1) !== entry) return;
        this.show(before);
        this.steps.value = { past: past.slice(0, -1), future: [] };
      },
    };
    this.open = gesture;
    return gesture;
  }

  /** Cancels an open gesture; returns whether there was one. */
  cancelGesture(): boolean {
    const gesture = this.open;
    gesture?.cancel();
    return gesture !== null;
  }

  /** Undoes the last step and returns its label, or null if there was none. */
  undo(): string | null {
    this.open?.commit();
    const { past } = this.steps.value;
    this.goTo(past.length - 1);
    return past.at(-1)?.label ?? null;
  }

  /** Redoes the step that was undone last and returns its label, or null if there was none. */
  redo(): string | null {
    this.open?.commit();
    const { past, future } = this.steps.value;
    this.goTo(past.length + 1);
    return future.at(-1)?.label ?? null;
  }

  /**
   * Goes to where so many of all steps have been taken, from 0 to their number. A count out of this
   * range does nothing.
   */
  goTo(count: number): void {
    this.open?.commit();
    const { past, future } = this.steps.value;
    if (count === past.length || count < 0 || count > past.length + future.length) return;
    const [history, scene] = stepTo(this.steps.value, count);
    this.show(scene);
    this.steps.value = history;
  }

  /** Uses one batch, so that no subscriber sees a session that does not match the scene. */
  private show(after: Scene): void {
    const before = this.current.value;
    if (after === before) return;
    batch(() => {
      this.current.value = after;
      this.onChange(before, after);
    });
  }
}
