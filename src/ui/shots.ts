import { effect } from '@preact/signals-core';
import { sameValue } from '../core/same-value.ts';
import {
  addShot,
  type AspectId,
  changeShot,
  newShot,
  ratioOf,
  removeShot,
  type Shot,
  shotById,
} from '../document/shots.ts';
import { frameWithin, framingOf, type ShotFrame, widened } from '../view/shot-frame.ts';
import type { Looking, Telling } from './editor.ts';
import { moveCamera } from './move-camera.ts';

/** The form of the first shot; later ones have that of the shot before. */
const firstAspect: AspectId = '4:5';

/** Keeps the view framed as the shot that is shown has it. */
export function followShots(editor: Looking): void {
  effect(() => {
    const ratio = ratioOf(shownShot(editor));
    const { framing } = editor.viewer;
    if ((framing.peek()?.ratio ?? null) !== ratio) framing.value = framingOf(ratio);
  });
}

/** The shot whose frame the view shows, if any. */
export function shownShot({
  store,
  session,
}: Pick<Looking, 'store' | 'session'>): Shot | undefined {
  return shotById(store.scene.value, session.shownShot.value);
}

/** The frame of the shot that is shown. */
export function shotFrameOf({ aspect, framing }: Looking['viewer']): ShotFrame {
  return frameWithin(aspect, framing.value?.ratio ?? null);
}

/**
 * Keeps the present view as a new shot and shows its frame. Nothing in the view moves: the shot has
 * what the frame surrounds.
 */
export function takeShot(editor: Looking & Telling): void {
  const { store, session, viewer, notice } = editor;
  const scene = store.scene.value;
  const aspect = (shownShot(editor) ?? scene.shots.at(-1))?.aspect ?? firstAspect;
  const draft = newShot(scene, viewer.viewCamera.value, aspect);
  const { height } = frameWithin(viewer.aspect, ratioOf(draft));
  const shot = { ...draft, camera: widened(draft.camera, height) };
  store.dispatch(addShot(shot));
  session.shownShot.value = shot.id;
  viewer.camera.value = shot.camera;
  notice.value = `${shot.name} added`;
}

/** Shows a shot's frame and moves the camera to it. */
export function goToShot({ session, viewer, notice }: Looking & Telling, shot: Shot): void {
  const { height } = frameWithin(viewer.aspect, ratioOf(shot));
  const from = widened(viewer.viewCamera.value, height);
  session.firstPerson.value = false;
  session.shownShot.value = shot.id;
  viewer.camera.value = from;
  notice.value = shot.name;
  moveCamera(viewer, from, shot.camera);
}

/** Whether the camera was moved since the shot that is shown was taken or updated. */
export function isMoved(editor: Looking): boolean {
  const shot = shownShot(editor);
  return shot !== undefined && !sameValue(shot.camera, editor.viewer.camera.value);
}

/** Gives the shot that is shown the present camera. */
export function updateShot(editor: Looking & Telling): void {
  const { store, viewer, notice } = editor;
  const shot = shownShot(editor);
  if (!shot) return;
  const label = `Update ${shot.name}`;
  store.dispatch(changeShot(shot.id, { camera: viewer.camera.value }, label));
  notice.value = `${shot.name} updated`;
}

export function setAspect(editor: Looking, aspect: AspectId): void {
  const shot = shownShot(editor);
  if (shot) editor.store.dispatch(changeShot(shot.id, { aspect }, `${shot.name} ${aspect}`));
}

/** Hides the frame; the view stays as it is. */
export function leaveShot({ session, viewer }: Looking): void {
  const camera = viewer.viewCamera.value;
  session.shownShot.value = null;
  viewer.camera.value = camera;
}

export function removeShownShot(editor: Looking & Telling): void {
  const shot = shownShot(editor);
  if (!shot) return;
  leaveShot(editor);
  editor.store.dispatch(removeShot(shot));
  editor.notice.value = `${shot.name} removed`;
}
