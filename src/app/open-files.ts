import type { Character } from '../core/character.ts';
import { loadPart } from '../core/failure.ts';
import type { Pose } from '../core/pose.ts';
import { openCharacter, openCharacters } from '../document/open-characters.ts';
import type { ActorLook } from '../document/actor-look.ts';
import {
  type Actor,
  type KeptState,
  type Source,
  sourceOf,
  type Transform,
} from '../document/scene.ts';
import { dropJoints } from '../document/reconcile.ts';
import { selectedActor } from '../document/selected-actor.ts';
import type { Session } from '../document/session.ts';
import type { Store } from '../document/store.ts';
import { isUntouched } from '../document/untouched.ts';
import type { Evaluations } from '../evaluation/evaluations.ts';
import { placeInRow } from '../evaluation/placing.ts';
import { sceneBounds } from '../evaluation/scene-bounds.ts';
import type { FileEntry } from '../formats/format.ts';
import type { ReadCharacter, ReadProgress } from '../formats/read-characters.ts';
import { defaultDeformation, kernelOf } from '../skinning/registry.ts';
import type { MethodId } from '../skinning/method.ts';
import { type CatalogueEntry, fetchBundled } from './catalogue.ts';
import type { OpenedFiles } from './renewal.ts';
import { loadReadFirst, readFiles } from './read-files.ts';

/**
 * The source of characters, which is their files if it is absent, and whether they are added to the others or replace the selected one, or
 * all of an untouched scene.
 */
export interface OpenWay {
  readonly source?: Source;
  readonly add: boolean;
  /** Where a character stands; beside the others, if absent. */
  readonly place?: Transform;
  /** Whether opening is no step of undo, as for a scene that is on its way. */
  readonly quiet?: boolean;
}

/**
 * If one drop has more characters than this, the others are only listed, so that the scene is not
 * crowded.
 */
const mostAtOnce = 12;

/** The result of opening files that were dropped, chosen or fetched. */
export interface OpenOutcome {
  /** All characters that were found; the first of them is open. */
  readonly found: readonly ReadCharacter[];
  readonly opened: Character | null;
  /** What stays as it was, if the same files were opened again. */
  readonly kept?: string;
  readonly posed: boolean;
  /** The name of an image that covers the selected character now, if one came. */
  readonly cover?: string;
  /** What came of a motion, if one was among the files, for the status line. */
  readonly motion?: string;
  /** Whether the characters were added beside the others. */
  readonly added: boolean;
}

/**
 * Opens files. A character replaces the selected one and a pose is set on it; each is one step of
 * undo. Files that the open character lacks complete it, and its own files, changed, update it.
 */
export class FileOpener {
  readonly store: Store;
  readonly session: Session;
  private readonly evaluations: Evaluations;
  /** How new characters are drawn, as far as the workspace says. */
  private readonly newLook: () => Partial<ActorLook>;
  /** The files of each opened character, so that later drops can complete or update it. */
  private readonly files = new WeakMap<Character, readonly FileEntry[]>();

  constructor(
    store: Store,
    session: Session,
    evaluations: Evaluations,
    newLook: () => Partial<ActorLook>,
  ) {
    this.newLook = newLook;
    this.store = store;
    this.session = session;
    this.evaluations = evaluations;
  }

  /** Fetches and opens a bundled character with its pose; its motions come later. */
  async openBundled(
    entry: CatalogueEntry,
    signal: AbortSignal,
    onProgress: ReadProgress,
    way: OpenWay,
  ): Promise<OpenOutcome | undefined> {
    // Before the first picture there is nothing to keep responsive, and a worker would load its own
    // copy of much of the page's code first. What reads the files comes while they are on their way.
    const isFirst = this.store.scene.value.actors.length === 0;
    const [files, readHere, poseReader] = await Promise.all([
      fetchBundled(entry, signal),
      isFirst ? loadReadFirst(entry.files) : undefined,
      entry.pose === undefined ? undefined : loadPart(import('./bundled-pose.ts')),
    ]);
    const pose = files.find(({ path }) => path.endsWith('.json'));
    const parts = files.filter((file) => file !== pose);
    const { characters, diagnostics } = readHere
      ? await readHere(parts, onProgress)
      : await readFiles(parts, signal, onProgress);
    const problems = [...diagnostics];
    const [first] = characters;
    const skeleton = first?.character.skeleton;
    const q = skeleton && pose && (await poseReader?.readBundledPose(pose, skeleton, problems));
    await this.prepare(characters);
    if (signal.aborted) return undefined;
    if (first) this.showAll([first], way, q && { q });
    this.session.problems.value = problems;
    const opened = first?.character ?? null;
    return { found: characters, opened, posed: false, added: way.add };
  }

  /** Loads the kernels of the characters, so that none is first shown with a substitute method. */
  async prepare(found: readonly ReadCharacter[]): Promise<void> {
    const deformations = found.map(({ character }) => defaultDeformation(character));
    await this.evaluations.prepare(deformations.map((each) => kernelOf(each).id));
  }

  /**
   * Shows characters in their files' poses. They are added beside all others, or replace the selected
   * actor or an untouched scene; several stand in a row.
   *
   * @param pose of the first character
   */
  showAll(found: readonly ReadCharacter[], way: OpenWay, pose?: Pose): void {
    const { add } = way;
    const shown = found.slice(0, mostAtOnce);
    const replaced = add ? [] : this.replaced;
    const ids = replaced.map(({ id }) => id);
    const others = this.evaluations.all().filter(({ state }) => !ids.includes(state.id));
    // Among others, a new character stands where the replaced one stood; alone, it gets the default
    // place.
    const kept = others.length > 0 && shown.length === 1 ? replaced[0]?.transform : undefined;
    const places = placeInRow(
      sceneBounds(others),
      shown.map(({ character }) => character),
    );
    for (const read of shown) this.keep(read);
    const actors = shown.map(({ character, files }, index) => ({
      character,
      method: this.methodFor(character),
      look: this.newLook(),
      kept: {
        source: way.source ?? sourceOf(files),
        transform: way.place ?? kept ?? places[index]!,
        ...(index === 0 && pose),
      },
    }));
    const edit = openCharacters(ids, actors);
    if (way.quiet) this.store.amend(edit);
    else this.store.dispatch(edit);
    this.beginClip(shown[0]!.character);
    dropJoints(this.session);
  }

  /**
   * Replaces an actor by its files, which were read again. Its pose, shape and clip are kept, and
   * playing continues.
   */
  renew(read: ReadCharacter, before: Actor, kept: KeptState): void {
    const { character } = read;
    this.keep(read);
    this.store.dispatch(openCharacter(before.id, character, this.methodFor(character), kept));
    if (before.clips.length === 0) this.beginClip(character);
  }

  /** Remembers the files of a character. */
  keep({ character, files }: ReadCharacter): void {
    if (files.length > 0) this.files.set(character, files);
  }

  /** The files of a character; none, if they are not the user's or not known. */
  filesOf(character: Character): readonly FileEntry[] {
    return this.files.get(character) ?? [];
  }

  private beginClip({ clips }: Character): void {
    this.session.clipIndex.value = 0;
    // While another actor plays, the time belongs to its clip.
    if (!this.session.playing.value) this.session.clipTime.value = clips[0]?.start ?? 0;
  }

  /** The selected character with its files, if these are known. */
  get openedFiles(): OpenedFiles | undefined {
    const character = this.selected?.character;
    const files = character && this.files.get(character);
    return files && { character, files };
  }

  /** What a new character replaces: the selected actor, or a whole scene that nobody touched. */
  private get replaced(): readonly Actor[] {
    if (isUntouched(this.store)) return this.store.scene.value.actors;
    return this.selected ? [this.selected] : [];
  }

  /** Whether opening replaces a character of a scene that the user made. */
  get isReplacing(): boolean {
    return this.selected !== undefined && !isUntouched(this.store);
  }

  get selected(): Actor | undefined {
    return selectedActor(this.store, this.session);
  }

  /** The pose that the selected character shows. */
  get shownPose(): Required<Pose> | undefined {
    return this.evaluations.selected()?.snapshot();
  }

  /**
   * The character's default method, unless the user chose another one for the selected character.
   */
  private methodFor(character: Character): MethodId {
    const before = this.selected;
    const chosen = before && before.method !== defaultDeformation(before.character).method;
    return chosen ? before.method : defaultDeformation(character).method;
  }
}
