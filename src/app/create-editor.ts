import { type Signal, signal } from '@preact/signals-core';
import { resetPose } from '../document/commands.ts';
import { selectedCharacter } from '../document/document.ts';
import type { Session } from '../document/session.ts';
import type { Store } from '../document/store.ts';
import { writeObj } from '../formats/obj/write-obj.ts';
import { poseToJson } from '../formats/pose-json.ts';
import { formats } from '../formats/registry.ts';
import { copyText } from '../ui/copy-text.ts';
import type { Editor } from '../ui/editor.ts';
import type { WorkspaceId } from '../ui/workspace.ts';
import { encodePicture } from '../view/picture.ts';
import type { Verification, Viewer } from '../view/viewer.ts';
import { type CatalogueEntry, FetchError, fetchBundled } from './catalogue.ts';
import { download } from './download.ts';
import type { FileOpener, OpenOutcome } from './open-files.ts';
import { workspaces } from './workspaces.ts';

/** Joins state, view and files to what the interface can ask for. */
export function createEditor(
  store: Store,
  session: Session,
  viewer: Viewer,
  opener: FileOpener,
  catalogue: Signal<readonly CatalogueEntry[]>,
): Editor {
  const workspaceId = signal<WorkspaceId>(workspaces[0]!.id);
  const openedId = signal<string | null>(null);
  const verification = signal<Verification | null>(null);
  const notice = signal('');
  const selected = () => selectedCharacter(store.document.value);

  const editor: Editor = {
    store,
    session,
    viewer,
    workspaces,
    workspaceId,
    bundled: catalogue,
    openedId,
    verification,
    notice,
    helpOpen: signal(false),
    fileExtensions: [...formats.flatMap(({ extensions }) => extensions), '.json'],

    async openFiles(files) {
      await whileBusy('Reading…', async () => {
        const outcome = await opener.open(files);
        if (outcome.character) openedId.value = null;
        finishOpening(outcome);
      });
    },

    async openBundled(id) {
      const entry = catalogue.value.find((each) => each.id === id);
      if (!entry) {
        notice.value = `There is no character "${id}"`;
        return;
      }
      await whileBusy(`Loading ${entry.label}…`, async () => {
        const outcome = await opener.open(await fetchBundled(entry));
        if (outcome.character) openedId.value = id;
        finishOpening(outcome);
      });
    },

    setWorkspace(id) {
      const workspace = workspaces.find((each) => each.id === id);
      if (!workspace) return;
      const changed = workspaceId.value !== id;
      workspaceId.value = id;
      viewer.camera.value = workspace.camera;
      if (workspace.framed) viewer.frameAll();
      if (!changed) return;
      session.shading.value = workspace.shading;
      session.showSkin.value = workspace.showSkin;
      session.showSkeleton.value = workspace.showSkeleton;
      session.showAxes.value = workspace.showAxes;
    },

    resetAll() {
      const state = selected();
      if (state) store.dispatch(resetPose(state.id));
    },

    async copyPose() {
      const copied = await copyText(poseText());
      notice.value = copied ? 'Pose copied' : 'The browser did not let the pose be copied';
    },

    savePose() {
      const state = selected();
      if (state) download(`${state.character.name}.pose.json`, poseText(), 'application/json');
    },

    exportMesh() {
      const state = selected();
      if (!state || state.character.mesh.pointCount === 0) return;
      const bytes = writeObj(state.character.mesh, viewer.vertices('cpu'));
      download(`${state.character.name}-posed.obj`, bytes as BlobPart, 'text/plain');
      notice.value = 'Posed mesh saved as OBJ';
    },

    async savePicture(format) {
      const blob = await encodePicture(viewer.capture(), format);
      const extension = format === 'jpeg' ? 'jpg' : format;
      download(`${selected()?.character.name ?? 'sinew'}.${extension}`, blob, blob.type);
      notice.value = 'Picture saved';
    },

    verify() {
      verification.value = viewer.verify();
    },
  };
  return editor;

  function poseText(): string {
    const state = selected();
    const json = state ? poseToJson(state.character.skeleton, { q: state.q }) : {};
    return `${JSON.stringify(json, null, 2)}\n`;
  }

  function finishOpening({ character, posed, diagnostics }: OpenOutcome): void {
    if (character) {
      verification.value = null;
      const workspace = workspaces.find(({ id }) => id === workspaceId.value);
      if (workspace?.framed) viewer.frameAll();
      notice.value = `${character.name} opened`;
    } else if (posed) notice.value = 'Pose set';
    else if (diagnostics.length > 0) notice.value = 'Nothing could be opened; see Problems';
  }

  /** Shows the word while the work goes on; what the page's server refuses becomes a notice. */
  async function whileBusy(word: string, work: () => Promise<void>): Promise<void> {
    session.busy.value = word;
    try {
      await work();
    } catch (error) {
      if (!(error instanceof FetchError)) throw error;
      notice.value = error.message;
    } finally {
      session.busy.value = null;
    }
  }
}
