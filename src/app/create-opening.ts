import { computed, type Signal, signal } from '@preact/signals-core';
import { selectActor } from '../document/reconcile.ts';
import { selectedActor } from '../document/selected-actor.ts';
import type { Session } from '../document/session.ts';
import type { Store } from '../document/store.ts';
import type { Evaluations } from '../evaluation/evaluations.ts';
import type { ReadCharacter } from '../formats/read-characters.ts';
import type { Opening, ThemeChoice } from '../ui/editor.ts';
import type { WorkspaceId } from '../ui/workspace.ts';
import type { Verification } from '../view/verify.ts';
import type { Viewer } from '../view/viewer.ts';
import { type CatalogueEntry, fetchBundled } from './catalogue.ts';
import { FetchError } from './fetch-file.ts';
import { FileOpener, type OpenOutcome } from './open-files.ts';
import { ProgressMeter } from './progress-meter.ts';
import { TaskStartError } from './run-task.ts';
import { workspaces } from './workspaces.ts';

/** Opens characters and workspaces: all that the first picture needs of the editor. */
export function createOpening(
  store: Store,
  session: Session,
  evaluations: Evaluations,
  viewer: Viewer,
  catalogue: Signal<readonly CatalogueEntry[]>,
): Opening {
  const opener = new FileOpener(store, session, evaluations);
  const workspaceId = signal<WorkspaceId>(workspaces[0]!.id);
  const openedId = computed(() => {
    const source = selectedActor(store, session)?.source;
    return source?.kind === 'bundled' ? source.id : null;
  });
  const own = signal<readonly ReadCharacter[]>([]);
  const verification = signal<Verification | null>(null);
  const selected = computed(() => selectedActor(store, session)?.character);
  // What was verified is of one character, whatever puts another in its place.
  selected.subscribe(() => (verification.value = null));
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
    openedId,
    verification,
    progress: meter.shown,
    notice,
    theme: signal<ThemeChoice>('system'),

    async openFiles(files, add = false) {
      const outcome = await whileOpening('Reading', async (signal) => {
        const { openOwnFiles } = await import('./open-own-files.ts');
        const openBundled = (id: string): Promise<void> => opening.openBundled(id);
        return openOwnFiles(opener, files, { signal, onProgress: meter.report, openBundled, add });
      });
      if (!outcome) return;
      const { found, opened, reopened, posed } = outcome;
      if (opened) {
        own.value = found;
        const more = found.length > 1 ? ` and ${found.length - 1} more` : '';
        showOpened(`${opened.name}${more}`, reopened ? 'updated; pose and camera kept' : word(add));
      } else if (posed) notice.value = 'Pose set';
      else notice.value = 'Nothing could be opened; see Problems';
    },

    async openBundled(id, add = false) {
      const entry = catalogue.value.find((each) => each.id === id);
      if (!entry) {
        notice.value = `There is no character "${id}"`;
        return;
      }
      const source = { kind: 'bundled', id } as const;
      // A copy of what is there already shares all but its pose.
      const same = store.scene.value.actors.find(
        ({ source: from }) => from.kind === 'bundled' && from.id === id,
      );
      if (add && same) {
        opener.showAll([{ character: same.character, files: [] }], { source, add });
        showOpened(entry.label, word(add));
        return;
      }
      const outcome = await whileOpening(`Loading ${entry.label}`, async (signal) =>
        opener.openBundled(await fetchBundled(entry, signal), signal, meter.report, {
          source,
          add,
        }),
      );
      if (outcome?.opened) showOpened(entry.label, word(add));
    },

    openOwn(read, add = false) {
      const there = store.scene.value.actors.find(({ character }) => character === read.character);
      // Already in the scene, it stays as it was posed.
      if (there && !add) selectActor(session, store.scene.value, there.id);
      else {
        opener.showAll([read], { source: { kind: 'files' }, add });
        showOpened(read.character.name, word(add));
      }
    },

    cancelOpening() {
      current.abort();
      meter.clear();
      notice.value = 'Cancelled';
    },

    async whenOpened() {
      let last;
      do await (last = latest);
      while (last !== latest);
    },

    setWorkspace(id) {
      const workspace = workspaces.find((each) => each.id === id);
      if (!workspace) return;
      const changed = workspaceId.value !== id;
      workspaceId.value = id;
      viewer.camera.value = workspace.camera;
      if (workspace.framed) viewer.frameAll();
      if (changed) session.show(workspace.look);
    },
  };
  return opening;

  /** Ends what is being opened, and opens; what fails becomes a word, and the page stays as it was. */
  async function whileOpening(
    title: string,
    work: (signal: AbortSignal) => Promise<OpenOutcome | undefined>,
  ): Promise<OpenOutcome | undefined> {
    current.abort();
    const { signal } = (current = new AbortController());
    const working = meter.during(title, () => work(signal));
    latest = working.catch(() => undefined); // which is told below
    try {
      return await working;
    } catch (error) {
      if (signal.aborted) return undefined;
      if (error instanceof FetchError || error instanceof TaskStartError)
        notice.value = error.message;
      else {
        notice.value = 'Sinew itself failed at this; the page is as it was';
        reportError(error);
      }
      return undefined;
    }
  }

  function showOpened(name: string, what: string): void {
    const workspace = workspaces.find(({ id }) => id === workspaceId.value);
    if (workspace?.framed && !what.startsWith('updated')) viewer.frameAll();
    notice.value = `${name} ${what}`;
  }
}

function word(add: boolean): string {
  return add ? 'added' : 'opened';
}
