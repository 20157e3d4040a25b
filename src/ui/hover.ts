import type { HandleId } from '../document/session.ts';
import { boneAt, type BoneTarget } from '../view/pick.ts';
import { bodyHandleAt, handleAt } from '../view/pick-gizmo.ts';
import { pointAt } from '../view/pick-point.ts';
import type { Looking } from './editor.ts';
import { trailKeysOf } from './trail-keys-shown.ts';
import type { ToolPlace } from './tool.ts';

/**
 * A scene of more triangles lights no limb outside of bone mode: after each change of the pose, the
 * first pick would stop the page for longer than a moment.
 */
const mostTriangles = 400_000;

/**
 * Highlights what a press at a place of the view would reach: a handle, or else a limb. While a clip
 * plays no limb is highlighted, since it would not stay under the pointer.
 */
export function hoverAt(editor: Looking, place: ToolPlace | null): void {
  const handle = place && (trailKeysOf(editor.session)?.at(place) ?? handleAt(editor, place));
  if (handle !== null) {
    showHoveredHandle(editor, handle);
    return;
  }
  const canPick = place !== null && !editor.session.playing.value && canLight(editor);
  const body = canPick ? bodyHandleAt(editor, place) : null;
  if (body) {
    showHoveredHandle(editor, body.id);
    return;
  }
  const target = canPick ? boneAt(editor, place) : null;
  showHover(editor, place, target);
  if (place && target) editor.session.hoveredPoint.value = weightPointAt(editor, place, target);
}

/**
 * The point at a place, where weights are shown and nothing of another character is in front of it.
 */
export function weightPointAt(
  editor: Looking,
  place: ToolPlace,
  target: BoneTarget | null,
): number | null {
  const { showWeights, selectedActorId } = editor.session;
  const isOther = target !== null && target.actorId !== selectedActorId.value;
  return showWeights.value && !isOther ? pointAt(editor, place) : null;
}

function canLight({ store, session }: Looking): boolean {
  const sizes = store.scene.value.actors.map(({ character }) => character.mesh.indices.length / 3);
  return session.boneMode.value || sizes.reduce((sum, size) => sum + size, 0) <= mostTriangles;
}

/** Highlights the limb under the pointer, or nothing. */
export function showHover(
  { session }: Looking,
  place: ToolPlace | null,
  target: BoneTarget | null,
): void {
  session.hoveredHandle.value = null;
  if (!target) session.hoveredPoint.value = null;
  const { actorId, joint, bone } = session.hoveredLimb.value ?? {};
  const isSame = target?.actorId === actorId && target?.joint === joint && target?.bone === bone;
  if (!isSame) session.hoveredLimb.value = target;
  session.hoverPlace.value = place && target ? [place.pixelX, place.pixelY] : null;
}

/** Highlights a handle, which lies over all limbs. */
export function showHoveredHandle(editor: Looking, handle: HandleId): void {
  showHover(editor, null, null);
  editor.session.hoveredHandle.value = handle;
}
