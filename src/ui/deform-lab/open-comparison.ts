import { batch } from '@preact/signals-core';
import type { Camera } from '../../document/camera.ts';
import { comparisonOf } from '../../document/comparison.ts';
import { setPose } from '../../document/edits.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import type { Session } from '../../document/session.ts';
import type { Gesture } from '../../document/store.ts';
import { type TellingPose, tellingPoses } from '../../posing/telling-poses.ts';
import type { Editor, Looking, Telling } from '../editor.ts';
import { moveCamera } from '../move-camera.ts';
import { type Compared, comparedOf } from './compared.ts';
import { differenceText } from './difference-text.ts';
import { cameraAt, placeOfWorst, viewPlace } from './place-of-worst.ts';

/** A smaller difference, as a part of the height, is hardly seen. */
export const telling = 0.01;

/** What a comparison has changed besides itself, and gives back at its end. */
interface Visit {
  /** The camera before it was moved, and whether only the comparison has moved it since. */
  camera: { readonly before: Camera; readonly isOwn: () => boolean } | null;
  /** The pose that was taken to see a difference. */
  offered: Gesture | null;
}

const visits = new WeakMap<Session, Visit>();

function visitOf(session: Session): Visit {
  let visit = visits.get(session);
  if (!visit) visits.set(session, (visit = { camera: null, offered: null }));
  return visit;
}

/** Compares the selected character's method with another one, or ends the comparison. */
export async function toggleComparison(editor: Looking & Telling): Promise<void> {
  if (editor.session.comparison.value) leaveComparison(editor);
  else await openComparison(editor);
}

async function openComparison(editor: Looking & Telling): Promise<void> {
  const { store, session, evaluations, notice } = editor;
  const actor = selectedActor(store, session);
  if (!actor || actor.character.mesh.pointCount === 0) {
    notice.value = 'There is no character with a mesh whose methods could be compared';
    return;
  }
  const blends = actor.method === 'linear-blend';
  const opened = comparisonOf(blends ? ['own', 'dual-quaternion'] : ['linear-blend', 'own']);
  // Linear blend stands in for a method that is still loading, so that the comparison can be shown,
  // and closed again, from the first moment.
  session.comparison.value = opened;
  await evaluations.prepare([blends ? 'dual-quaternion' : 'linear-blend']);
  if (session.comparison.peek() === opened) showWorst(editor);
}

/** Shows the lab with its numbers, and compares methods in it. */
export async function openLab(editor: Editor): Promise<void> {
  editor.tab.value = 'deform';
  editor.drawer.value = 'right';
  if (!editor.session.comparison.value) await openComparison(editor);
}

/** Ends the comparison. Camera and pose are again as they were, unless the user went on with them. */
export function leaveComparison({ session, viewer }: Looking): void {
  const { camera, offered } = visitOf(session);
  visits.delete(session);
  batch(() => {
    session.comparison.value = null;
    session.inspectedPoint.value = null;
    offered?.withdraw();
    if (camera?.isOwn()) viewer.camera.value = camera.before;
  });
}

/** The poses in which the selected character shows how methods differ. */
export function offeredPoses({ evaluations }: Looking): readonly TellingPose[] {
  const shown = evaluations.selected();
  return shown ? tellingPoses(shown.state.character, shown.poseToEdit.q) : [];
}

/** Gives the selected character such a pose, in place of one that it got in this way. */
export function takeOffered(editor: Looking & Telling, label: string): void {
  const { store, session } = editor;
  const visit = visitOf(session);
  visit.offered?.withdraw();
  const [pose, actor] = [
    offeredPoses(editor).find((each) => each.label === label),
    selectedActor(store, session),
  ];
  if (!pose || !actor) return;
  visit.offered = store.begin(label);
  visit.offered.preview(setPose(actor.id, pose.q, label));
  visit.offered.commit();
  showWorst(editor);
}

/**
 * Says what the largest difference is, and brings it into view where it can be seen, with a wipe
 * through it.
 */
export function showWorst(editor: Looking & Telling): void {
  const compared = tellWorst(editor);
  if (compared) aimAt(editor, compared);
}

/**
 * Says it anew after something else is compared, as another character, and goes there unless the user
 * has moved the camera.
 */
export function showWorstAgain(editor: Looking & Telling): void {
  tellWorst(editor);
  aimAgain(editor);
}

function tellWorst(editor: Looking & Telling): Compared | null {
  const { notice } = editor;
  const compared = comparedOf(editor);
  if (!compared?.worst) {
    notice.value = 'The methods put every vertex at the same place in this pose';
    return null;
  }
  const { worst, base, size } = compared;
  notice.value =
    `${worst.kernel.label} and ${base.kernel.label} differ by at most ` +
    differenceText(worst.difference.largest, size);
  return compared;
}

/** Aims again after the view was divided anew, unless the user has moved the camera since. */
export function aimAgain(editor: Looking): void {
  const compared = comparedOf(editor);
  if (compared && visitOf(editor.session).camera?.isOwn()) aimAt(editor, compared);
}

/** Moves camera and wipe to the largest difference. */
function aimAt(editor: Looking, compared: Compared): void {
  const { session, viewer } = editor;
  const place = placeOfWorst(compared);
  if (!place) return;
  const { worst, size } = compared;
  let goal = viewer.viewCamera.peek();
  if (worst!.difference.largest >= telling * size.height && !viewer.framing.peek()) {
    const visit = visitOf(session);
    const from = viewer.camera.peek();
    const before = visit.camera?.isOwn() ? visit.camera.before : from;
    goal = cameraAt(before, viewer.aspect, compared, place);
    visit.camera = { before, isOwn: moveCamera(viewer, from, goal) };
  }
  wipeThrough(editor, goal);
}

/** Moves the nearest wipe to the place of the largest difference. */
function wipeThrough(editor: Looking, camera: Camera): void {
  const { session, viewer } = editor;
  const comparison = session.comparison.peek();
  const compared = comparedOf(editor);
  const place = compared && placeOfWorst(compared);
  if (comparison?.layout !== 'wipe' || comparison.wipes.length !== 1 || !place) return;
  const [x] = viewPlace(camera, viewer.aspect, place.other);
  session.comparison.value = { ...comparison, wipes: [Math.min(0.95, Math.max(0.05, x))] };
}
