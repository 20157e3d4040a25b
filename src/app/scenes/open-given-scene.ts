import { type Diagnostic, hasErrors } from '../../core/diagnostics.ts';
import { addActors, replaceScene } from '../../document/scene-edits.ts';
import { withoutCircles } from '../../document/followers.ts';
import { actorOf } from '../../document/scene-json/actor-json.ts';
import { readScene, type SceneDescription } from '../../document/scene-json/read-scene.ts';
import { type Actor, type ActorId, freeId, type SourceFile } from '../../document/scene.ts';
import { showView, type ViewState } from '../../document/view-state.ts';
import type { FileEntry } from '../../formats/format.ts';
import { kernelOf } from '../../skinning/registry.ts';
import { FileFinder } from './find-files.ts';
import { type LoadedCharacter, loadCharacter } from './load-characters.ts';
import type { GivenScene } from './scene-among.ts';
import type { SceneParts } from './scene-parts.ts';
import { freshTarget, type SceneTarget } from './scene-target.ts';

interface OpenSceneOptions {
  /** What the scene is called in messages. */
  readonly name: string;
  /** Whether the characters are added to the others, without what surrounds them. */
  readonly add?: boolean;
  /** Whether a scene with any error is refused: a link with one is damaged. */
  readonly strict?: boolean;
  /** Where it is saved next, as far as that is known. */
  readonly target?: Partial<SceneTarget>;
  /** Problems that were found before. */
  readonly problems?: readonly Diagnostic[];
}

/**
 * Opens a scene in place of all, or beside the others, as one step of undo. Characters whose files
 * are not there are left out, and the page then asks for their files.
 *
 * @returns whether it was opened
 */
export async function openGivenScene(
  parts: SceneParts,
  given: Omit<GivenScene, 'isFile'>,
  signal: AbortSignal,
  { name, add = false, strict = false, target = {}, problems = [] }: OpenSceneOptions,
): Promise<boolean> {
  const { session } = parts.opening;
  const { value, diagnostics } = readScene(given.file, given.text);
  if (!value || (strict && hasErrors(diagnostics))) {
    session.problems.value = [...problems, ...diagnostics];
    return false;
  }
  const arrival = new SceneArrival(parts, value, name);
  const actors = await arrival.load(given.files, signal);
  if (!actors) return false;
  arrival.show(actors, add, target);
  session.problems.value = [...problems, ...value.log.diagnostics, ...arrival.problems];
  arrival.ask();
  return true;
}

/** Says in words why a scene was refused; the problems of the page give the place. */
export function whyRefused({ opening }: SceneParts): string {
  const isNewer = opening.session.problems.value.some(({ code }) => code === 'scene/version');
  return isNewer ? 'a newer Sinew wrote it' : 'it is damaged';
}

/** A scene whose characters come, some of them perhaps later than others. */
class SceneArrival {
  readonly problems: Diagnostic[] = [];
  private readonly parts: SceneParts;
  private readonly scene: SceneDescription;
  private readonly name: string;
  /** The id of the first actor; the others follow. */
  private readonly firstId: ActorId;
  private readonly loaded = new Map<number, LoadedCharacter>();
  private missing: readonly SourceFile[] = [];

  constructor(parts: SceneParts, scene: SceneDescription, name: string) {
    this.parts = parts;
    this.scene = scene;
    this.name = name;
    this.firstId = freeId(parts.opening.store.scene.peek());
  }

  /**
   * Loads the characters that are not there yet, and returns their actors; nothing if the signal is
   * aborted.
   *
   * @param given files that came for them
   */
  async load(given: readonly FileEntry[], signal: AbortSignal): Promise<Actor[] | undefined> {
    const { parts, scene } = this;
    const finder = new FileFinder(knownFiles(parts), given);
    const came = new Map<number, LoadedCharacter>();
    const missing: SourceFile[] = [];
    const found = (at: number) => {
      const number = scene.actors[at]?.character ?? -1;
      const loaded = came.get(number) ?? this.loaded.get(number);
      return loaded && { id: this.firstId + at, skeleton: loaded.character.skeleton };
    };
    for (const [at, source] of scene.characters.entries()) {
      if (!source || this.loaded.has(at)) continue;
      const outcome = await loadCharacter(parts, source, finder, signal, this.problems);
      if (signal.aborted) return undefined;
      if (outcome.loaded) came.set(at, outcome.loaded);
      missing.push(...outcome.missing);
    }
    const actors = scene.actors.flatMap((actor, at) => {
      const loaded = came.get(actor.character);
      if (!loaded) return [];
      const { character, source } = loaded;
      return [actorOf(actor, this.firstId + at, character, source, found)];
    });
    await parts.opening.evaluations.prepare(actors.map((actor) => kernelOf(actor).id));
    if (signal.aborted) return undefined;
    for (const [at, loaded] of came) this.keep(at, loaded);
    this.missing = missing;
    return withoutCircles(actors);
  }

  show(actors: readonly Actor[], add: boolean, target: Partial<SceneTarget>): void {
    const { parts, scene, name } = this;
    const { store, notice } = parts.opening;
    if (add) store.dispatch(addActors(actors, `Add ${name}`));
    else store.dispatch(replaceScene({ actors, ...scene.surroundings }, `Open ${name}`));
    if (!add) {
      store.isMade.value = true;
      Object.assign(parts.target, freshTarget(name), target);
    }
    if (scene.view && !add) this.view(scene.view);
    else parts.opening.frameOpened();
    notice.value = `${name} ${add ? 'added' : 'opened'}`;
  }

  /** Asks for the files that are missing, if any are. */
  ask(): void {
    const { wanted, dialog } = this.parts.opening;
    if (this.missing.length === 0) {
      wanted.value = null;
      if (dialog.value === 'wanted') dialog.value = null;
      return;
    }
    wanted.value = {
      scene: this.name,
      files: [...new Set(this.missing.map(({ path }) => path))],
      give: (files, signal) => this.complete(files, signal),
    };
    dialog.value = 'wanted';
  }

  /** Adds the characters whose files came; returns whether any did. */
  private async complete(files: readonly FileEntry[], signal: AbortSignal): Promise<boolean> {
    const { opening } = this.parts;
    const { store, session, notice } = opening;
    const before = this.problems.length;
    const actors = await this.load(files, signal);
    if (!actors || actors.length === 0) return false;
    store.dispatch(addActors(actors, `Complete ${this.name}`));
    session.problems.value = [...this.scene.log.diagnostics, ...this.problems.slice(before)];
    if (!this.scene.view) opening.frameOpened();
    notice.value = `${actors.map((actor) => actor.name).join(', ')} came to ${this.name}`;
    this.ask();
    return true;
  }

  private keep(at: number, loaded: LoadedCharacter): void {
    const { opener, own } = this.parts;
    this.loaded.set(at, loaded);
    opener.keep(loaded);
    const isListed = own.value.some(({ character }) => character === loaded.character);
    if (loaded.source.kind === 'files' && !isListed) own.value = [...own.value, loaded];
  }

  private view(view: ViewState): void {
    const { opening, workspaceId } = this.parts;
    const { viewer, session, store, workspaces } = opening;
    const scene = store.scene.value;
    const selected = scene.actors.findIndex(
      ({ id }) => id === this.firstId + (view.selected ?? NaN),
    );
    showView(scene, session, { ...view, selected: selected < 0 ? null : selected });
    const workspace = workspaces.find(({ id }) => id === view.workspace);
    if (workspace) workspaceId.value = workspace.id;
    viewer.camera.value = view.camera;
  }
}

/** The files of the characters that the page has. */
function knownFiles({ opening, opener, own }: SceneParts): readonly FileEntry[] {
  const open = opening.store.scene.peek().actors.map(({ character }) => opener.filesOf(character));
  return [...open.flat(), ...own.peek().flatMap(({ files }) => files)];
}
