import { type Influence, influencesOf, noJoint, sumOf } from '../../core/skin.ts';
import { printable } from '../../core/diagnostics.ts';
import type { Actor } from '../../document/scene.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import {
  editedSkin,
  resetInfluencesOf,
  resetSkin,
  setInfluencesOf,
} from '../../document/skin-edits.ts';
import type { Gesture } from '../../document/store.ts';
import type { Looking, Telling } from '../editor.ts';

/** The inspected vertex, with its weights as they are edited. */
export interface EditedVertex {
  readonly actor: Actor;
  readonly point: number;
  readonly row: readonly Influence[];
}

export function editedVertex({ store, session }: Looking): EditedVertex | null {
  const actor = selectedActor(store, session);
  const point = session.inspectedPoint.value;
  if (!actor || point === null || point >= actor.character.mesh.pointCount) return null;
  return { actor, point, row: influencesOf(editedSkin(actor), point) };
}

/** The name of a palette entry. */
export function entryName({ character: { skin, skeleton } }: Actor, entry: number): string {
  const joint = skin.paletteJoint[entry]!;
  return joint === noJoint ? 'no joint' : printable(skeleton.names[joint]!, 40);
}

/** Gives the vertex another row, as one step of undo or within a gesture. */
export function setRow(
  { store }: Looking,
  { actor, point }: EditedVertex,
  row: readonly Influence[],
  label: string,
  gesture?: Gesture,
): void {
  const edit = setInfluencesOf(actor.id, new Map([[point, row]]), label);
  if (gesture) gesture.preview(edit);
  else store.dispatch(edit);
}

function canNormalize({ row }: EditedVertex): boolean {
  const sum = sumOf(row);
  return Math.abs(sum) > 1e-6 && Math.abs(sum - 1) > 1e-6;
}

/** Divides the vertex's weights by their sum. */
export function normalizeVertex(editor: Looking & Telling): void {
  const vertex = editedVertex(editor);
  if (!vertex) return;
  if (!canNormalize(vertex)) {
    editor.notice.value = 'The weights of this vertex sum to 1 already, or to 0';
    return;
  }
  const sum = sumOf(vertex.row);
  const row = vertex.row.map(({ entry, weight }) => ({ entry, weight: weight / sum }));
  setRow(editor, vertex, row, `Normalize the weights of vertex ${vertex.point}`);
}

/** Gives the vertex the weights of its file again. */
export function resetVertex(editor: Looking): void {
  const vertex = editedVertex(editor);
  if (vertex) editor.store.dispatch(resetInfluencesOf(vertex.actor.id, vertex.point));
}

/** Gives all vertices of the selected character the weights of its file again. */
export function resetVertices({ store, session }: Looking): void {
  const actor = selectedActor(store, session);
  if (actor?.skin) store.dispatch(resetSkin(actor.id));
}
