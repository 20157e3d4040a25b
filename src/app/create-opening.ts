import { type Signal, signal } from '@preact/signals-core';
import { loadPart } from '../core/failure.ts';
import { dress } from '../document/look-edits.ts';
import { selectActor } from '../document/reconcile.ts';
import { selectedActor } from '../document/selected-actor.ts';
import type { Session } from '../document/session.ts';
import type { Store } from '../document/store.ts';
import type { Evaluations } from '../evaluation/evaluations.ts';
import type { ReadCharacter } from '../formats/read-characters.ts';
import { failureText } from '../ui/attempt.ts';
import type { Opening, ThemeChoice } from '../ui/editor.ts';
import type { Workspace, WorkspaceId } from '../ui/workspace.ts';
import type { Viewer } from '../view/viewer.ts';
import type { CatalogueEntry, CatalogueScene } from './catalogue.ts';
import { FileOpener, type OpenOutcome } from './open-files.ts';
import { type OpeningScene, openScene } from './open-scene.ts';
import { ProgressMeter } from './progress-meter.ts';
import type { SceneParts } from './scenes/scene-parts.ts';
import { freshTarget } from './scenes/scene-target.ts';
import { workspaces } from './workspaces.ts';

/** What opens characters, and bundled scenes too. */
export interface OpeningOfScenes extends Opening {
  /** What saving and opening scenes needs. */
  readonly parts: SceneParts;
  /** @param shown settles when the first character was drawn, for which the others wait */
  openScene(scene: CatalogueScene, shown: Promise<void>): OpeningScene;
}

/**
 * Opens characters and workspaces. It contains everything of the editor that the first picture
 * needs.
 */
export function createOpening(
  store: Store,
  session: Session,
  evaluations: Evaluations,
  viewer: Viewer,
  catalogue: Signal<readonly CatalogueEntry[]>,
): OpeningOfScenes {
  const workspaceId = signal<WorkspaceId>(workspaces[0]!.id);
  const workspaceNow = () => workspaces.find(({ id }) => id === workspaceId.value)!;
  const opener = new FileOpener(store, session, evaluations, () => workspaceNow().actorLook);
  const own = signal<readonly ReadCharacter[]>([]);
  const notice = signal('');
  const meter = new ProgressMeter();
  let current = new AbortController();
  let latest: Promise<unknown> = Promise.resolve();

  const opening: Opening = {
    store,
    session,
    evaluations,
    viewer,
    workspaces,
    workspaceId,
    bundled: catalogue,
    own,
    progress: meter.shown,
    notice,
    theme: signal<ThemeChoice>('system'),
    dialog: signal(null),
    question: signal(null),
    wanted: signal(null),
    restored: signal(''),

    async openFiles(files, add = false, handles = []) {
      await opening.whileWorking('Reading', async (signal) => {
        const [{ receiveFiles }, entries, given] = await Promise.all([
          loadPart(import('./receive-files.ts')),
          files,
          handles,
        ]);
        const openBundled = async (id: string): Promise<void> => {
          const entry = entryOf(id);
          if (entry) await loadBundled(entry, signal, false);
        };
        const receiver = { ...parts, openBundled, showOpened };
        await receiveFiles(receiver, { files: entries, add, handles: given }, signal);
      });
    },

    async openBundled(id, add = false) {
      const entry = entryOf(id);
      if (!entry) {
        notice.value = `There is no character "${id}"`;
        return;
      }
      // A copy of an existing character shares everything with it except the pose.
      const same = store.scene.value.actors.find(
        ({ source: from }) => from.kind === 'bundled' && from.id === id,
      );
      if (add && same) {
        opener.showAll([{ character: same.character, files: [] }], { source: same.source, add });
        showOpened(entry.label, word(add));
        return;
      }
      await opening.whileWorking(`Loading ${entry.label}`, (signal) =>
        loadBundled(entry, signal, add),
      );
    },

    openOwn(read, add = false) {
      const there = store.scene.value.actors.find(({ character }) => character === read.character);
      // A character that is already in the scene keeps its pose.
      if (there && !add) selectActor(session, store.scene.value, there.id);
      else {
        opener.showAll([read], { add });
        showOpened(read.character.name, word(add));
      }
    },

    async whileWorking(title, work) {
      current.abort();
      const { signal } = (current = new AbortController());
      const working = meter.during(title, () => work(signal, meter.report));
      latest = working.catch(() => undefined); // the failure is reported below
      try {
        return await working;
      } catch (error) {
        if (signal.aborted) return undefined;
        notice.value = failureText(error);
        return undefined;
      }
    },

    cancelWork() {
      current.abort();
      meter.clear();
      notice.value = 'Canceled';
    },

    async whenDone() {
      let last;
      do await (last = latest);
      while (last !== latest);
    },

    setWorkspace(id) {
      const workspace = workspaces.find((each) => each.id === id);
      if (!workspace) return;
      workspaceId.value = id;
      opening.resetCamera();
      session.show(workspace.look);
      session.posesBy.value = workspace.posesBy;
      dressSelected(workspace);
    },

    resetCamera() {
      const { camera, framed } = workspaceNow();
      viewer.camera.value = camera;
      if (framed) viewer.frameAll();
    },

    frameOpened() {
      if (workspaceNow().framed) viewer.frameAll();
    },
  };
  const target = freshTarget();
  const parts: SceneParts = { opening, opener, own, meter, workspaceId, target, entryOf };
  return {
    ...opening,
    parts,
    openScene: (scene, shown) => openScene(scene, catalogue.value, opener, opening, shown),
  };

  /** Draws the selected character as a workspace does; this is a step of undo, unlike the rest. */
  function dressSelected({ label, actorLook, normals }: Workspace): void {
    const actor = selectedActor(store, session);
    if (actor) store.dispatch(dress(actor.id, actorLook, normals, `${label} look`));
  }

  function entryOf(id: string): CatalogueEntry | undefined {
    return catalogue.value.find((each) => each.id === id);
  }

  async function loadBundled(
    entry: CatalogueEntry,
    signal: AbortSignal,
    add: boolean,
  ): Promise<OpenOutcome | undefined> {
    const source = { kind: 'bundled', id: entry.id } as const;
    const outcome = await opener.openBundled(entry, signal, meter.report, { source, add });
    if (outcome?.opened) showOpened(entry.label, word(add));
    return outcome;
  }

  function showOpened(name: string, what: string): void {
    if (!what.startsWith('updated')) opening.frameOpened();
    notice.value = `${name} ${what}`;
  }
}

function word(add: boolean): string {
  return add ? 'added' : 'opened';
}
