import { effect, untracked, type Signal } from '@preact/signals-core';
import { isUntouched } from '../../document/untouched.ts';
import type { Keeping } from '../../ui/editor.ts';
import { keepValue } from '../../ui/kept.ts';
import { forgetScene, keepScene } from './kept-scenes.ts';
import { keptMarker } from './at-start.ts';
import { holdScene, openScenes } from './scene-locks.ts';
import type { SceneParts } from './scene-parts.ts';
import { freshTarget } from './scene-target.ts';
import { filesOfScene, sceneText } from './scene-text.ts';
import { viewStateOf } from '../../document/view-state.ts';

/** In milliseconds: how long nothing changes until the scene is kept, and the longest wait. */
const [pause, longestWait] = [250, 2000];

/**
 * Keeps the scene in this browser after each change, so that it comes back after a crash or a closed
 * tab. A scene that nobody made is not kept, nor is an empty one.
 */
export class SceneKeeper {
  private readonly parts: SceneParts;
  private readonly state: Signal<Keeping>;
  /** The id under which the scene is kept now, and what gives up its lock. */
  private id: string | null = null;
  private release: (() => void) | undefined;
  /** The hashes of the files that the record of this id has. */
  private stored: ReadonlySet<string> = new Set();
  private timer: ReturnType<typeof setTimeout> | undefined;
  /** When the first change came that is not kept yet. */
  private since = 0;
  private work: Promise<void> = Promise.resolve();
  private lastFault = '';

  constructor(parts: SceneParts, state: Signal<Keeping>) {
    this.parts = parts;
    this.state = state;
    effect(() => {
      this.readAll();
      untracked(() => this.changed());
    });
  }

  /** Reads every signal whose change is kept. While a clip plays, its time is not. */
  private readAll(): void {
    const { opening, workspaceId } = this.parts;
    const { store, session, viewer } = opening;
    const [scene, camera] = [store.scene.value, viewer.camera.value];
    isUntouched(store);
    if (!session.playing.value) viewStateOf(scene, session, camera, workspaceId.value);
  }

  private changed(): void {
    const now = performance.now();
    if (this.timer === undefined) this.since = now;
    clearTimeout(this.timer);
    if (this.isWorthKeeping) this.state.value = this.state.value === 'failed' ? 'failed' : 'soon';
    const wait = Math.max(0, Math.min(pause, this.since + longestWait - now));
    this.timer = setTimeout(() => {
      this.timer = undefined;
      this.work = this.work.then(() => this.keepNow());
    }, wait);
  }

  private get isWorthKeeping(): boolean {
    const { store } = this.parts.opening;
    return store.scene.peek().actors.length > 0 && !isUntouched(store);
  }

  private async keepNow(): Promise<void> {
    try {
      if (this.isWorthKeeping) await this.put();
      else await this.drop();
      this.lastFault = '';
      // A change that came meanwhile has its own timer.
      if (this.timer === undefined) this.state.value = this.isWorthKeeping ? 'kept' : 'nothing';
    } catch (error) {
      this.state.value = 'failed';
      this.tell(faultText(error));
    }
  }

  private async put(): Promise<void> {
    const { parts } = this;
    if (parts.target.id !== this.id) await this.begin(parts.target.id);
    const { id, name } = parts.target;
    const scene = parts.opening.store.scene.peek();
    const text = sceneText(parts);
    const files = filesOfScene(parts, scene).filter(({ sha256 }) => sha256 !== undefined);
    const hashes = files.map(({ sha256 }) => sha256!);
    const added = new Map<string, Blob>();
    for (const file of files) {
      if (!this.stored.has(file.sha256!)) {
        added.set(file.sha256!, new Blob([(await file.bytes()) as BlobPart]));
      }
    }
    const label = name === 'scene' ? scene.actors.map((actor) => actor.name).join(', ') : name;
    const record = { id, name: label, time: Date.now(), text, hashes };
    await keepScene(record, added, await openScenes());
    this.stored = new Set(hashes);
    keepValue(keptMarker, id);
    sessionStorage.setItem(keptMarker, id);
  }

  /** Keeps another scene from now on; the record of the one before stays as it is. */
  private async begin(id: string): Promise<void> {
    const { target } = this.parts;
    this.release?.();
    this.release = await holdScene(id);
    if (!this.release) {
      // Another tab has it, as when a tab was duplicated; or the browser has no locks, and then no
      // two pages may use one id.
      target.id = freshTarget().id;
      this.release = await holdScene(target.id);
    }
    this.id = target.id;
    this.stored = new Set();
  }

  /** Removes the record of a scene that is not worth keeping any more. */
  private async drop(): Promise<void> {
    if (this.id === null) return;
    sessionStorage.removeItem(keptMarker);
    if (this.id === this.parts.target.id) await forgetScene(this.id);
    else {
      // It is the record of the scene before, which stays.
      this.release?.();
      this.id = null;
    }
    this.stored = new Set();
  }

  /** Says what is wrong, once as long as it stays wrong. */
  private tell(text: string): void {
    if (text === this.lastFault) return;
    this.lastFault = text;
    this.parts.opening.notice.value = text;
  }
}

const advice = 'Ctrl/Cmd+S saves it in a file';

function faultText(error: unknown): string {
  const isFull = error instanceof DOMException && error.name === 'QuotaExceededError';
  return isFull
    ? `This browser has no room to keep the scene; ${advice}`
    : `This browser does not keep the scene, as in a private window; ${advice}`;
}
