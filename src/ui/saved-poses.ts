import { printable } from '../core/diagnostics.ts';
import type { Skeleton } from '../core/skeleton.ts';
import { subtreeEnd } from '../core/subtree.ts';
import {
  addSavedPose,
  changeSavedPose,
  moveSavedPose,
  newSavedPose,
  removeSavedPose,
  type SavedPose,
} from '../document/saved-poses.ts';
import { selectedJoints } from '../document/selected-joints.ts';
import { namePose } from '../posing/named-pose.ts';
import type { Looking, Telling } from './editor.ts';

/** What of a pose is kept: all of it, the selected joints with all below them, or these alone. */
export type PosePart = 'whole' | 'branch' | 'joints';

const longestName = 80;

/** The pose of the scene that was applied or kept last. */
export function chosenSavedPose({
  store,
  session,
}: Pick<Looking, 'store' | 'session'>): SavedPose | undefined {
  const key = session.chosenPose.value;
  return store.scene.value.poses.find((pose) => keyOf(pose) === key);
}

/** The key of a pose of the scene, among all that the library offers. */
export function keyOf({ id }: SavedPose): string {
  return `saved ${id}`;
}

/** Keeps what the selected character shows, or a part of it, in the scene. */
export function keepPose(editor: Looking & Telling, part: PosePart): void {
  const { evaluations, session, store, notice } = editor;
  const shown = evaluations.selected();
  if (!shown) return;
  const { character } = shown.state;
  const selected = selectedJoints(session);
  const joints = jointsOf(character.skeleton, part, selected);
  if (joints.length === 0) return;
  const stem = part === 'whole' ? 'Pose' : printable(character.skeleton.names[selected[0]!]!, 70);
  const pose = namePose(character, shown.snapshot(), joints);
  const saved = newSavedPose(store.scene.value, stem, pose);
  store.dispatch(addSavedPose(saved));
  session.chosenPose.value = keyOf(saved);
  notice.value = `${saved.name} kept in the library`;
}

function jointsOf(skeleton: Skeleton, part: PosePart, selected: readonly number[]): number[] {
  const all = Array.from({ length: skeleton.jointCount }, (_, joint) => joint);
  if (part === 'whole') return all;
  if (part === 'joints') return all.filter((joint) => selected.includes(joint));
  return all.filter((joint) =>
    selected.some((first) => joint >= first && joint < subtreeEnd(skeleton, first)),
  );
}

/** Puts what is shown in the place of the chosen pose's values, for the joints that it names. */
export function overwriteChosen(editor: Looking & Telling): void {
  const { evaluations, store, notice } = editor;
  const shown = evaluations.selected();
  const saved = chosenSavedPose(editor);
  if (!shown || !saved) return;
  const { character } = shown.state;
  const { names } = character.skeleton;
  const named = new Set(saved.joints.map(({ name }) => name));
  const joints = names.flatMap((name, joint) =>
    named.has(name) || saved.morphs.length > 0 ? [joint] : [],
  );
  if (joints.length === 0) {
    notice.value = `${shown.state.name} has none of the joints of ${saved.name}`;
    return;
  }
  const pose = namePose(character, shown.snapshot(), joints);
  store.dispatch(changeSavedPose(saved.id, pose, `Overwrite the pose ${saved.name}`));
  notice.value = `${saved.name} is now as shown`;
}

/** Renames a pose, unless the text has nothing to read. */
export function renameSavedPose(
  { store, notice }: Looking & Telling,
  { id, name: old }: SavedPose,
  text: string,
): void {
  const name = printable(text.trim(), longestName);
  if (name === '' || name === old) return;
  store.dispatch(changeSavedPose(id, { name }, `Rename the pose ${old}`));
  notice.value = `${old} is now called ${name}`;
}

/** Moves the chosen pose by a number of places. */
export function moveChosen(editor: Looking, by: number): void {
  const saved = chosenSavedPose(editor);
  if (saved) editor.store.dispatch(moveSavedPose(saved, by));
}

export function removeChosen(editor: Looking & Telling): void {
  const saved = chosenSavedPose(editor);
  if (!saved) return;
  editor.session.chosenPose.value = null;
  editor.store.dispatch(removeSavedPose(saved));
  editor.notice.value = `${saved.name} removed from the library`;
}
