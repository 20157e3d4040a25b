import { effect } from '@preact/signals-core';
import type { Diagnostic } from '../core/diagnostics.ts';
import { loadPart } from '../core/failure.ts';
import { bindClip, removeActor, setMorphWeight, setPose } from '../document/edits.ts';
import type { Actor } from '../document/scene.ts';
import { selectedActor } from '../document/selected-actor.ts';
import type { Session, SkinDevice } from '../document/session.ts';
import type { Shot } from '../document/shots.ts';
import type { Verification } from '../document/verification.ts';
import { memoryFile } from '../formats/file-entry.ts';
import type { FileEntry } from '../formats/format.ts';
import { poseFromJson, type PoseJson } from '../formats/pose-json.ts';
import { poseToJson } from '../formats/write-pose-json.ts';
import { formatDiagnostic } from '../core/diagnostics.ts';
import type { Editor } from '../ui/editor.ts';
import { fileEntry } from '../ui/file-entry.ts';
import type { KernelId } from '../skinning/method.ts';
import type { Camera } from '../document/camera.ts';
import type { MovieSettings } from '../view/movie/movie-settings.ts';
import type { PictureFormat } from '../view/picture/encode-picture.ts';
import type { PassImageId } from '../view/picture/make-passes.ts';
import { posedPoints } from '../view/posed-points.ts';
import { verifyShown } from '../view/verify.ts';
import { fetchFile } from './fetch-file.ts';

/** The id or the name of an actor; if several have the name, the first. */
export type ActorName = number | string;

export interface CharacterSummary {
  readonly id: number;
  readonly name: string;
  readonly joints: readonly string[];
  readonly vertexCount: number;
  readonly triangleCount: number;
  readonly selected: boolean;
}

export interface CaptureOptions {
  readonly format?: PictureFormat;
  /** In pixels, both or neither; if absent, the size of the view. */
  readonly width?: number;
  readonly height?: number;
  /** Floor and backdrop; true if absent. */
  readonly background?: boolean;
  /** Views side by side, from the left; if absent, those of the page. */
  readonly views?: readonly CaptureView[];
  /** The id or the name of a shot, in whose aspect the picture is; it takes the place of `views`. */
  readonly shot?: number | string;
  /** Samples on each side of a pixel, 1 to 4; 1 if absent. */
  readonly samples?: number;
  /** Whether compared methods have their names, mark and legend, as in a saved picture; false if absent. */
  readonly labels?: boolean;
  /** A picture of data in place of colors, as PNG. */
  readonly pass?: PassImageId;
  /** The most samples on a side of a tile; chosen by the size if absent. */
  readonly tileLimit?: number;
}

/** A view of the scene; absent properties are as the page shows it. */
export interface CaptureView {
  readonly camera?: Partial<Camera>;
  readonly method?: KernelId;
}

/** `window.sinew` gives scripts and tests access to the page; see docs/scripting.md. */
export interface Scripting {
  /** Settles when the first character has been drawn. */
  readonly ready: Promise<void>;
  /** Opens files, the bundled character with an id, or URLs of the page's own origin. */
  open(source: readonly File[] | FileList | string | readonly string[]): Promise<void>;
  /** Opens a bundled scene, by its id, in place of all characters. */
  openScene(id: string): Promise<void>;
  readonly characters: readonly CharacterSummary[];
  /** Adds a character, given as for `open`, beside the existing ones and selects it. */
  add(source: readonly File[] | FileList | string | readonly string[]): Promise<void>;
  /** Selects the actor that the members below use if none is named. */
  select(actor: ActorName): void;
  remove(actor?: ActorName): void;
  /** Returns the pose, or sets it; joints that are not named take the file's pose. */
  pose(json?: PoseJson, actor?: ActorName): PoseJson;
  /** Returns the weights of the character's morphs by name, or sets those that are named. */
  morphs(weights?: Readonly<Record<string, number>>, actor?: ActorName): Record<string, number>;
  /** The names of the selected character's clips. */
  readonly clips: readonly string[];
  /** Shows a clip's pose at a time (in seconds), paused; the chosen clip if none is named. */
  seek(time: number, clip?: string, actor?: ActorName): void;
  /** Plays or pauses the chosen clip. */
  togglePlay(): void;
  /** (vertices × 3) posed positions, in the file's order and units. */
  vertices(device: SkinDevice, actor?: ActorName): Float32Array;
  verify(actor?: ActorName): Verification | null;
  /** Settles when everything that is being read or decoded has been drawn, not as a draft. */
  settled(): Promise<void>;
  /** The shots of the scene. */
  readonly shots: readonly Pick<Shot, 'id' | 'name' | 'aspect'>[];
  /** Returns the view's pixels as a file, or those of the same view at another size. */
  capture(options?: CaptureOptions): Promise<Blob>;
  /** Returns a movie as a file; absent options are as the dialog has them at first. */
  movie(options?: Partial<MovieSettings>): Promise<Blob>;
  readonly problems: readonly Diagnostic[];
  /** Live WebGL objects by kind. */
  readonly liveObjects: Readonly<Record<string, number>>;
}

export function createScripting(editor: Editor, ready: Promise<void>): Scripting {
  const { store, session, evaluations, viewer } = editor;
  return {
    ready,
    open: (source) => open(source, false),
    async openScene(id) {
      await editor.openBundledScene(id);
      await settled();
    },
    add: (source) => open(source, true),
    select: (name) => editor.select(find(name)!.id),
    remove(name) {
      const actor = find(name);
      if (actor) store.dispatch(removeActor(actor));
    },
    get characters() {
      const selected = find();
      return store.scene.value.actors.map(({ id, name, character: { skeleton, mesh } }) => ({
        id,
        name,
        joints: skeleton.names,
        vertexCount: mesh.pointCount,
        triangleCount: mesh.indices.length / 3,
        selected: id === selected?.id,
      }));
    },
    pose(json, name) {
      const actor = find(name);
      if (!actor) return {};
      const { skeleton } = actor.character;
      if (json === undefined) return poseToJson(skeleton, evaluations.of(actor).poseToEdit);
      const { value, diagnostics } = poseFromJson('pose', json, skeleton);
      if (!value) throw new Error(diagnostics.map(formatDiagnostic).join('\n'));
      if (diagnostics.length > 0) session.problems.value = diagnostics;
      store.dispatch(setPose(actor.id, value.q));
      return poseToJson(skeleton, value);
    },
    morphs(weights = {}, name) {
      const actor = find(name);
      if (!actor) return {};
      const names = actor.character.morphs.map((morph) => morph.name);
      const shownWeights = (): Float64Array => evaluations.of(find(actor.id)!).pose.morphWeights;
      for (const [morph, weight] of Object.entries(weights)) {
        const index = names.indexOf(morph);
        if (index === -1 || !Number.isFinite(weight)) {
          throw new Error(`expected a number for one of ${names.join(', ') || 'no morphs'}`);
        }
        store.dispatch(setMorphWeight(actor.id, shownWeights(), index, weight, `Shape ${morph}`));
      }
      const now = shownWeights();
      return Object.fromEntries(names.map((morph, index) => [morph, now[index]!]));
    },
    get clips() {
      return find()?.clips.map(({ name }) => name) ?? [];
    },
    seek(time, clip, name) {
      const actor = find(name);
      const isSelected = actor?.id === find()?.id;
      const clips = actor?.clips.map((each) => each.name) ?? [];
      const chosen = isSelected ? editor.transport.clipIndex : (actor?.clip ?? 0);
      const index = clip === undefined ? chosen : clips.indexOf(clip);
      if (!actor || clips[index] === undefined) {
        throw new Error(`expected one of ${clips.join(', ') || 'no clips'}`);
      }
      if (!isSelected) {
        store.amend(bindClip(actor.id, index));
        session.playing.value = false;
        session.clipTime.value = time;
        return;
      }
      if (index !== editor.transport.clipIndex) editor.transport.choose(index);
      editor.transport.goTo(time);
    },
    togglePlay: () => editor.transport.togglePlay(),
    vertices(device, name) {
      const actor = find(name);
      return actor ? posedPoints(viewer, actor, device) : new Float32Array(0);
    },
    async settled() {
      await settled();
      await drawnInFull(session);
    },
    verify: (name) => verifyShown(find(name), viewer),
    get shots() {
      return store.scene.value.shots.map(({ id, name, aspect }) => ({ id, name, aspect }));
    },
    async capture(options = {}) {
      await settled();
      await evaluations.settled(options.views?.flatMap(({ method }) => method ?? []));
      const { capture } = await loadPart(import('./capture.ts'));
      return capture(editor, options);
    },
    async movie(options = {}) {
      await settled();
      const { movieOf } = await loadPart(import('./movie/movie-of.ts'));
      return movieOf(editor, options);
    },
    get problems() {
      return session.problems.value;
    },
    get liveObjects() {
      return viewer.liveObjects;
    },
  };

  async function settled(): Promise<void> {
    await editor.whenDone();
    await evaluations.settled();
    await viewer.texturesShown();
  }

  /**
   * Returns the actor with a name, or the selected one; throws if there is no actor with the name.
   */
  function find(name?: ActorName): Actor | undefined {
    if (name === undefined) return selectedActor(store, session);
    const found = store.scene.value.actors.find(
      (actor) => actor.id === name || actor.name === name,
    );
    if (!found) throw new Error(`there is no actor ${JSON.stringify(name)}`);
    return found;
  }

  async function open(source: Parameters<Scripting['open']>[0], add: boolean): Promise<void> {
    if (typeof source === 'string' && editor.bundled.value.some(({ id }) => id === source)) {
      await editor.openBundled(source, add);
      await editor.whenDone();
    } else await editor.openFiles(await entriesOf(source), add);
  }
}

function entriesOf(
  source: readonly File[] | FileList | string | readonly string[],
): Promise<FileEntry[]> {
  const items = typeof source === 'string' ? [source] : Array.from<File | string>(source);
  return Promise.all(
    items.map(async (item) => {
      if (typeof item !== 'string') return fileEntry(item);
      const { path, bytes } = await fetchFile(new URL(item, document.baseURI));
      return memoryFile(path, bytes);
    }),
  );
}

/** Resolves when pictures are no drafts. While a clip plays they may stay drafts. */
function drawnInFull({ detail, playing }: Session): Promise<void> {
  return new Promise((resolve) => {
    const stop = effect(() => {
      if (detail.value === 'draft' && !playing.value) return;
      requestAnimationFrame(() => {
        stop();
        resolve();
      });
    });
  });
}
