import { signal } from '@preact/signals-core';
import { hasErrors } from '../core/diagnostics.ts';
import { loadPart } from '../core/failure.ts';
import { BallAngles } from '../document/ball-angles.ts';
import { PlaceAngles } from '../document/place-angles.ts';
import { removeActor, removeActors, resetPose } from '../document/edits.ts';
import { replaceScene } from '../document/scene-edits.ts';
import { type ActorId, emptyScene } from '../document/scene.ts';
import { openCharacter } from '../document/open-characters.ts';
import { selectActor } from '../document/reconcile.ts';
import { selectedActor } from '../document/selected-actor.ts';
import { isUntouched } from '../document/untouched.ts';
import { Transport } from '../document/transport.ts';
import { placeBeside } from '../evaluation/place-beside.ts';
import { sceneBounds } from '../evaluation/scene-bounds.ts';
import { readableExtensions, sceneExtension } from '../formats/extensions.ts';
import { writeObj } from '../formats/obj/write-obj.ts';
import { poseFormats } from '../formats/pose-formats.ts';
import { attempt } from '../ui/attempt.ts';
import type { Drawer, Editor, Keeping } from '../ui/editor.ts';
import { createHints } from '../ui/hints.ts';
import { focusJoint } from '../ui/focus-joint.ts';
import { plainMovie } from '../view/movie/movie-settings.ts';
import { plainSettings } from '../view/picture/picture-size.ts';
import { posedPoints } from '../view/posed-points.ts';
import { verifyShown } from '../view/verify.ts';
import type { CatalogueScene } from './catalogue.ts';
import type { OpeningOfScenes } from './create-opening.ts';
import { download } from '../ui/download.ts';
import { MotionFollower } from './follow-motions.ts';
import { freshTarget } from './scenes/scene-target.ts';

const poseExtensions = poseFormats.map(({ extension }) => extension);

/** Completes the opening to an editor with everything that the interface can ask for. */
export function createEditor(
  opening: OpeningOfScenes,
  canvas: HTMLCanvasElement,
  scenes: readonly CatalogueScene[],
): Editor {
  const { store, session, evaluations, viewer, notice } = opening;
  const selected = () => selectedActor(store, session);
  const keeping = signal<Keeping>('nothing');
  let added: Promise<void> = Promise.resolve();
  const motions = new MotionFollower(opening.parts);

  const editor: Editor = {
    ...opening,
    transport: new Transport(store, session, (message) => (notice.value = message)),
    ballAngles: new BallAngles(),
    placeAngles: new PlaceAngles(),
    recentEntries: signal([]),
    showsHistory: signal(false),
    showsRotationLab: signal(false),
    letterKeys: signal(true),
    picture: signal(plainSettings),
    movie: signal(plainMovie),
    tab: signal('pose'),
    hints: createHints(canvas, opening),
    drawer: signal<Drawer | null>(null),
    keeping,
    fileExtensions: [
      ...new Set([sceneExtension, ...readableExtensions, ...poseExtensions, '.png']),
    ],
    renaming: signal<ActorId | null>(null),

    scenes,

    async whenDone() {
      await opening.whenDone();
      await motions.whenDone();
    },

    async openBundledScene(id) {
      const scene = scenes.find((each) => each.id === id);
      if (!scene) {
        notice.value = `There is no scene "${id}"`;
        return;
      }
      Object.assign(opening.parts.target, freshTarget(scene.label));
      // The characters come one after another and belong to this step.
      const cleared = removeActors(`Open ${scene.label}`);
      if (isUntouched(store)) store.amend(cleared);
      else store.dispatch(cleared);
      await opening.openScene(scene, Promise.resolve()).all;
    },

    addBundled(id) {
      const open = (): Promise<void> => opening.openBundled(id, !isUntouched(store));
      const opened = added.then(() => opening.whenDone()).then(open);
      added = opened.catch(() => undefined); // the failure is reported by who waits for this one
      return opened;
    },

    async listRecent() {
      const { listRecent } = await loadPart(import('./recent-files.ts'));
      return listRecent();
    },

    async openRecent({ handles }) {
      const { filesOf } = await loadPart(import('./recent-files.ts'));
      await opening.openFiles(await filesOf(handles), !isUntouched(store), handles);
    },

    async forgetRecent() {
      const { forgetRecent } = await loadPart(import('./recent-files.ts'));
      await forgetRecent();
    },

    async listEarlier() {
      const { listEarlier } = await loadPart(import('./scenes/earlier-scenes.ts'));
      return listEarlier();
    },

    async openEarlier(id) {
      const { openEarlier } = await loadPart(import('./scenes/earlier-scenes.ts'));
      await openEarlier(opening.parts, id);
    },

    async startFresh() {
      const [first] = scenes;
      if (first) await editor.openBundledScene(first.id);
    },

    select(id) {
      selectActor(session, store.scene.value, id);
    },

    clearScene() {
      store.dispatch(replaceScene(emptyScene, 'New scene'));
      Object.assign(opening.parts.target, freshTarget());
      opening.wanted.value = null;
      notice.value = 'New scene';
    },

    removeSelected() {
      const actor = selected();
      if (!actor) return;
      store.dispatch(removeActor(actor));
      notice.value = `${actor.name} removed`;
    },

    duplicateSelected() {
      const actor = selected();
      if (!actor) return;
      const transform = placeBeside(sceneBounds(evaluations.all()), evaluations.of(actor));
      const kept = { ...actor, transform };
      store.dispatch(openCharacter(null, actor.character, actor.method, kept));
      notice.value = `${actor.name} added once more`;
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

    async bundledPoses(id, character) {
      const path = opening.bundled.value.find((each) => each.id === id)?.poses;
      if (path === undefined) return [];
      const { fetchBundledPoses } = await loadPart(import('./bundled-poses.ts'));
      return fetchBundledPoses(path, character);
    },

    async savePose(format = poseFormats[0]!) {
      const shown = evaluations.selected();
      if (!shown) return;
      const { character, name } = shown.state;
      const pose = shown.snapshot(); // of this moment, since the writer may still have to come
      const { write } = await format.load();
      const { files, losses } = write({ ...character, name }, pose);
      for (const { path, bytes } of files) download(path, bytes as BlobPart, 'text/plain');
      session.problems.value = losses;
      notice.value =
        losses.length > 0 ? 'Pose saved; what got lost is under Problems' : 'Pose saved';
    },

    async saveMotion(form) {
      const actor = selected();
      const index = editor.transport.clipIndex;
      if (!actor?.clips[index]) {
        notice.value = 'There is no motion to save';
        return;
      }
      const { saveMotion } = await loadPart(import('./save-motion.ts'));
      const losses = saveMotion(actor, index, form);
      session.problems.value = losses;
      if (hasErrors(losses)) notice.value = 'The motion was not saved; Problems says why';
      else if (losses.length > 0) notice.value = 'Motion saved; what got lost is under Problems';
      else notice.value = 'Motion saved';
    },

    async saveAs(format) {
      const shown = evaluations.selected();
      if (!shown) return;
      // The view may change while files are written, so this saves the pose of the present moment.
      const pose = shown.snapshot();
      // Few users save in another course's format, so its writers are loaded only when someone
      // does.
      const { saveAs } = await loadPart(import('./save-as.ts'));
      const { losses, motionsBeside } = await saveAs(shown.state, pose, format);
      session.problems.value = losses;
      const beside = motionsBeside > 0 ? ', with its motions beside it as MOTION.json' : '';
      if (hasErrors(losses)) notice.value = 'Not saved; Problems says why';
      else if (losses.length > 0) notice.value = `Saved${beside}; what got lost is under Problems`;
      else notice.value = `Saved${beside}, with nothing lost`;
    },

    async exportMesh() {
      await evaluations.settled();
      const state = selected();
      if (!state || state.character.mesh.pointCount === 0) {
        notice.value = 'There is no mesh to export';
        return;
      }
      const positions = posedPoints(viewer, state, 'cpu');
      const bytes = writeObj(state.character.mesh, { positions, normals: null });
      download(`${state.name}-posed.obj`, bytes as BlobPart, 'text/plain');
      notice.value = 'Posed mesh saved as OBJ';
    },

    async measure(input, control) {
      const { measureInWorker } = await loadPart(import('./measure-in-worker.ts'));
      return measureInWorker(input, control);
    },

    async saveComparison() {
      await evaluations.settled();
      const { saveComparison } = await loadPart(import('./save-comparison.ts'));
      saveComparison(editor);
    },

    async saveScene(asNew) {
      const { saveScene } = await loadPart(import('./scenes/save-scene.ts'));
      await saveScene(opening.parts, asNew);
    },

    async copyLink() {
      const { copyLink } = await loadPart(import('./scenes/copy-link.ts'));
      await copyLink(opening.parts);
    },

    async savePicture(target) {
      await evaluations.settled();
      const { savePicture } = await loadPart(import('./save-picture.ts'));
      await savePicture(editor, opening.parts, target);
    },

    async saveMovie() {
      const { saveMovie } = await loadPart(import('./movie/save-movie.ts'));
      await saveMovie(editor);
    },

    async movieChoices(plan) {
      const { movieChoices } = await loadPart(import('./movie/save-movie.ts'));
      return movieChoices(plan);
    },

    async verify() {
      await evaluations.settled();
      session.verification.value = verifyShown(selected(), viewer);
      if (!session.verification.value) notice.value = 'There is nothing on the GPU to verify';
    },

    async checkMachine() {
      const report = await opening.whileWorking(
        'Checking this machine',
        async (signal, onProgress) => {
          const { checkMachine } = await loadPart(import('./check-machine.ts'));
          return checkMachine(signal, onProgress);
        },
      );
      if (!report) return;
      download('sinew-machine.json', `${JSON.stringify(report, null, 2)}\n`, 'application/json');
      notice.value = `Report saved: ${report.summary}`;
    },
  };
  attempt(opening, keepScenes());
  return editor;

  /** Loaded after the rest of the page, since there is nothing to keep before the first change. */
  async function keepScenes(): Promise<void> {
    const { SceneKeeper } = await loadPart(import('./scenes/keep-scene.ts'));
    new SceneKeeper(opening.parts, keeping);
  }
}
