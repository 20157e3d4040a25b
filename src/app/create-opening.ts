import { computed, type Signal, signal } from '@preact/signals-core';
import { selectedCharacter, type Source } from '../document/document.ts';
import type { Session } from '../document/session.ts';
import type { Store } from '../document/store.ts';
import type { Evaluations } from '../evaluation/evaluations.ts';
import type { FileEntry } from '../formats/format.ts';
import type { ReadCharacter } from '../formats/read-characters.ts';
import type { Opening, ThemeChoice } from '../ui/editor.ts';
import type { WorkspaceId } from '../ui/workspace.ts';
import type { Verification } from '../view/verify.ts';
import type { Viewer } from '../view/viewer.ts';
import { type CatalogueEntry, FetchError, fetchBundled } from './catalogue.ts';
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
  const opener = new FileOpener(store, session);
  const workspaceId = signal<WorkspaceId>(workspaces[0]!.id);
  const openedId = computed(() => {
    const source = selectedCharacter(store.document.value)?.source;
    return source?.kind === 'bundled' ? source.id : null;
  });
  const own = signal<readonly ReadCharacter[]>([]);
  const verification = signal<Verification | null>(null);
  const selected = computed(() => selectedCharacter(store.document.value)?.character);
  // What was verified is of one character, whatever puts another in its place.
  selected.subscribe(() => (verification.value = null));
  const notice = signal('');
  const meter = new ProgressMeter();
  let current = new AbortController();

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

    async openFiles(files) {
      const outcome = await whileOpening('Reading', (signal) =>
        open(files, signal, { kind: 'files' }),
      );
      if (!outcome) return;
      const { found, opened, reopened, posed } = outcome;
      if (opened) {
        own.value = found;
        showOpened(opened.name, reopened);
      } else if (posed) notice.value = 'Pose set';
      else notice.value = 'Nothing could be opened; see Problems';
    },

    async openBundled(id) {
      const entry = catalogue.value.find((each) => each.id === id);
      if (!entry) {
        notice.value = `There is no character "${id}"`;
        return;
      }
      const outcome = await whileOpening(`Loading ${entry.label}`, async (signal) =>
        open(await fetchBundled(entry, signal), signal, { kind: 'bundled', id }),
      );
      if (outcome?.opened) showOpened(entry.label, false);
    },

    openOwn(character) {
      // Already open, it stays as it was posed.
      if (selectedCharacter(store.document.value)?.character === character.character) return;
      opener.show(character, { kind: 'files' });
      showOpened(character.character.name, false);
    },

    cancelOpening() {
      current.abort();
      meter.clear();
      notice.value = 'Cancelled';
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

  function open(files: readonly FileEntry[], signal: AbortSignal, source: Source) {
    return opener.open(files, signal, meter.report, (id) => opening.openBundled(id), source);
  }

  /** Ends what is being opened, and opens; what fails becomes a word, and the page stays as it was. */
  async function whileOpening(
    title: string,
    work: (signal: AbortSignal) => Promise<OpenOutcome | undefined>,
  ): Promise<OpenOutcome | undefined> {
    current.abort();
    const { signal } = (current = new AbortController());
    try {
      return await meter.during(title, () => work(signal));
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

  function showOpened(name: string, reopened: boolean): void {
    const workspace = workspaces.find(({ id }) => id === workspaceId.value);
    if (workspace?.framed && !reopened) viewer.frameAll();
    notice.value = reopened ? `${name} updated; pose and camera kept` : `${name} opened`;
  }
}
