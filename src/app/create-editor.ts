import { type Signal, signal } from '@preact/signals-core';
import { resetPose } from '../document/commands.ts';
import { selectedCharacter } from '../document/document.ts';
import type { Session } from '../document/session.ts';
import type { Store } from '../document/store.ts';
import { readableExtensions } from '../formats/extensions.ts';
import { writeObj } from '../formats/obj/write-obj.ts';
import { poseToJson } from '../formats/pose-json.ts';
import type { ReadCharacter } from '../formats/read-characters.ts';
import { copyText } from '../ui/copy-text.ts';
import type { Drawer, Editor, ThemeChoice } from '../ui/editor.ts';
import { focusJoint } from '../ui/focus-joint.ts';
import type { WorkspaceId } from '../ui/workspace.ts';
import type { Verification } from '../view/verify.ts';
import type { Viewer } from '../view/viewer.ts';
import { type CatalogueEntry, FetchError, fetchBundled } from './catalogue.ts';
import { download } from './download.ts';
import type { FileOpener } from './open-files.ts';
import { ProgressMeter } from './progress-meter.ts';
import { savePicture } from './save-picture.ts';
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
  const own = signal<readonly ReadCharacter[]>([]);
  const verification = signal<Verification | null>(null);
  const notice = signal('');
  const meter = new ProgressMeter();
  let opening = new AbortController();
  /** Ends what is being opened; what begins now ends with the signal. */
  const beginOpening = (): AbortSignal => {
    opening.abort();
    opening = new AbortController();
    return opening.signal;
  };
  const selected = () => selectedCharacter(store.document.value);

  const editor: Editor = {
    store,
    session,
    viewer,
    workspaces,
    workspaceId,
    bundled: catalogue,
    own,
    openedId,
    verification,
    theme: signal<ThemeChoice>('system'),
    progress: meter.shown,
    notice,
    helpOpen: signal(false),
    letterKeys: signal(true),
    drawer: signal<Drawer | null>(null),
    fileExtensions: [...readableExtensions, '.json', '.png'],

    async openFiles(files) {
      const signal = beginOpening();
      const outcome = await meter.during('Reading', () =>
        opener.open(files, signal, meter.report, (id) => editor.openBundled(id)),
      );
      if (!outcome) return;
      const { found, opened, reopened, posed } = outcome;
      if (opened) {
        own.value = found;
        openedId.value = null;
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
      const signal = beginOpening();
      try {
        const outcome = await meter.during(`Loading ${entry.label}`, async () => {
          const files = await fetchBundled(entry, signal);
          return opener.open(files, signal, meter.report, (id) => editor.openBundled(id));
        });
        if (!outcome?.opened) return;
        openedId.value = id;
        showOpened(entry.label, false);
      } catch (error) {
        if (signal.aborted) return;
        if (!(error instanceof FetchError)) throw error;
        notice.value = error.message;
      }
    },

    openOwn(character) {
      opener.show(character);
      openedId.value = null;
      showOpened(character.character.name, false);
    },

    cancelOpening() {
      opening.abort();
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

    editJoint(joint) {
      session.selectedJoint.value = joint;
      editor.drawer.value = 'right';
      focusJoint(joint);
    },

    async copyPose() {
      const copied = await copyText(poseText());
      notice.value = copied ? 'Pose copied' : 'The browser did not let the pose be copied';
    },

    savePose() {
      const state = selected();
      if (!state) return;
      download(`${state.character.name}.pose.json`, poseText(), 'application/json');
      notice.value = 'Pose saved';
    },

    exportMesh() {
      const state = selected();
      if (!state || state.character.mesh.pointCount === 0) {
        notice.value = 'There is no mesh to export';
        return;
      }
      const bytes = writeObj(state.character.mesh, viewer.vertices('cpu'));
      download(`${state.character.name}-posed.obj`, bytes as BlobPart, 'text/plain');
      notice.value = 'Posed mesh saved as OBJ';
    },

    async savePicture(options) {
      notice.value = await savePicture(viewer, selected(), openedId.value, options);
    },

    verify() {
      verification.value = viewer.verify();
      if (!verification.value) notice.value = 'There is nothing on the GPU to verify';
    },
  };
  return editor;

  function poseText(): string {
    const state = selected();
    const json = state ? poseToJson(state.character.skeleton, { q: state.q }) : {};
    return `${JSON.stringify(json, null, 2)}\n`;
  }

  function showOpened(name: string, reopened: boolean): void {
    verification.value = null;
    const workspace = workspaces.find(({ id }) => id === workspaceId.value);
    if (workspace?.framed && !reopened) viewer.frameAll();
    notice.value = reopened ? `${name} renewed; pose and camera kept` : `${name} opened`;
  }
}
