import type { Diagnostic } from '../core/diagnostics.ts';
import { setMorphWeight, setPose } from '../document/commands.ts';
import { selectedCharacter } from '../document/document.ts';
import type { SkinDevice } from '../document/session.ts';
import type { FileEntry } from '../formats/format.ts';
import { poseFromJson, type PoseJson, poseToJson } from '../formats/pose-json.ts';
import { formatDiagnostic } from '../core/diagnostics.ts';
import type { Editor } from '../ui/editor.ts';
import { fileEntry } from '../ui/file-entry.ts';
import { decodeImage } from '../view/decode-image.ts';
import { capturePicture, encodePicture, type PictureFormat } from '../view/picture.ts';
import { type Verification, verifyShown } from '../view/verify.ts';
import { fetchFile } from './catalogue.ts';

export interface CharacterSummary {
  readonly name: string;
  readonly joints: readonly string[];
  readonly vertexCount: number;
  readonly triangleCount: number;
  readonly selected: boolean;
}

export interface CaptureOptions {
  readonly format?: PictureFormat;
  /** Pixels, both or neither; the view's size where absent. */
  readonly width?: number;
  readonly height?: number;
  /** Floor and backdrop; true where absent. */
  readonly background?: boolean;
}

/** `window.sinew`: the page for scripts and tests; see docs/scripting.md. */
export interface Scripting {
  /** Settles when the first character has been drawn. */
  readonly ready: Promise<void>;
  /** Files to read, the id of a bundled character, or URLs of this page's own origin. */
  open(source: readonly File[] | FileList | string | readonly string[]): Promise<void>;
  readonly characters: readonly CharacterSummary[];
  /** The pose, or sets it: joints that are not named take the file's pose. */
  pose(json?: PoseJson): PoseJson;
  /** Weights of the character's morphs by name, or sets those that are named. */
  morphs(weights?: Readonly<Record<string, number>>): Record<string, number>;
  /** Names of the character's clips. */
  readonly clips: readonly string[];
  /** Shows a clip's pose at a time (seconds), paused; the chosen clip where none is named. */
  seek(time: number, clip?: string): void;
  /** Plays the chosen clip, or pauses it. */
  togglePlay(): void;
  /** (vertices × 3) posed positions, in the file's order and units. */
  vertices(device: SkinDevice): Float32Array;
  verify(): Verification | null;
  /** The view's pixels as a file, or the same view at another size. */
  capture(options?: CaptureOptions): Promise<Blob>;
  readonly problems: readonly Diagnostic[];
  /** Live WebGL objects by kind. */
  readonly liveObjects: Readonly<Record<string, number>>;
}

export function createScripting(editor: Editor, ready: Promise<void>): Scripting {
  const { store, session, evaluations, viewer } = editor;
  return {
    ready,
    async open(source) {
      if (typeof source === 'string' && editor.bundled.value.some(({ id }) => id === source)) {
        await editor.openBundled(source);
      } else await editor.openFiles(await entriesOf(source));
    },
    get characters() {
      const { characters, selectedId } = store.document.value;
      return characters.map(({ id, character: { name, skeleton, mesh } }) => ({
        name,
        joints: skeleton.names,
        vertexCount: mesh.pointCount,
        triangleCount: mesh.indices.length / 3,
        selected: id === selectedId,
      }));
    },
    pose(json) {
      const shown = evaluations.selected();
      if (!shown) return {};
      const { skeleton } = shown.state.character;
      if (json === undefined) return poseToJson(skeleton, shown.pose);
      const { value, diagnostics } = poseFromJson('pose', json, skeleton);
      if (!value) throw new Error(diagnostics.map(formatDiagnostic).join('\n'));
      if (diagnostics.length > 0) session.problems.value = diagnostics;
      store.dispatch(setPose(shown.state.id, value.q));
      return poseToJson(skeleton, value);
    },
    morphs(weights = {}) {
      const state = selectedCharacter(store.document.value);
      if (!state) return {};
      const names = state.character.morphs.map(({ name }) => name);
      for (const [name, weight] of Object.entries(weights)) {
        const index = names.indexOf(name);
        if (index === -1 || !Number.isFinite(weight)) {
          throw new Error(`expected a number for one of ${names.join(', ') || 'no morphs'}`);
        }
        store.dispatch(setMorphWeight(state.id, index, weight, `Shape ${name}`));
      }
      const now = selectedCharacter(store.document.value)!.morphWeights;
      return Object.fromEntries(names.map((name, index) => [name, now[index]!]));
    },
    get clips() {
      const state = selectedCharacter(store.document.value);
      return state?.character.clips.map(({ name }) => name) ?? [];
    },
    seek(time, clip) {
      const { clips } = this;
      const index = clip === undefined ? editor.transport.clipIndex : clips.indexOf(clip);
      if (clips[index] === undefined) {
        throw new Error(`expected one of ${clips.join(', ') || 'no clips'}`);
      }
      if (index !== editor.transport.clipIndex) editor.transport.choose(index);
      editor.transport.seek(time);
    },
    togglePlay: () => editor.transport.togglePlay(),
    vertices: (device) => viewer.vertices(device),
    verify: () => verifyShown(store, viewer),
    async capture({ format = 'png', width, height, background = true } = {}) {
      await texturesShown(store);
      const size = width !== undefined && height !== undefined ? { width, height } : undefined;
      return encodePicture(capturePicture(viewer, size, background), format);
    },
    get problems() {
      return session.problems.value;
    },
    get liveObjects() {
      return viewer.liveObjects;
    },
  };
}

/** Once the pictures of the character's surfaces are decoded and in the view. */
async function texturesShown({ document }: Editor['store']): Promise<void> {
  const images = selectedCharacter(document.value)?.character.images ?? [];
  if (images.length === 0) return;
  await Promise.all(images.map(decodeImage));
  await new Promise((resolve) => requestAnimationFrame(resolve));
}

function entriesOf(
  source: readonly File[] | FileList | string | readonly string[],
): Promise<FileEntry[]> {
  const items = typeof source === 'string' ? [source] : Array.from<File | string>(source);
  return Promise.all(
    items.map((item) =>
      typeof item === 'string' ? fetchFile(new URL(item, document.baseURI)) : fileEntry(item),
    ),
  );
}
