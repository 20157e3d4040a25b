import { type Diagnostic, hasErrors } from '../core/diagnostics.ts';
import { setPose } from '../document/edits.ts';
import { noParent, type Skeleton } from '../core/skeleton.ts';
import { firstRoot } from '../core/subtree.ts';
import { findJoint, type PoseJson } from '../formats/pose-json.ts';
import { readPoseJson } from '../formats/read-pose-json.ts';
import { mirrorJoints, symmetryOf } from '../posing/symmetry/symmetry.ts';
import type { Editor } from './editor.ts';
import { mirrorRemarks } from './mirroring.ts';
import { isMotionText, openMotion } from './open-motion.ts';
import { clipboardText } from './pose-clipboard.ts';

/** Pastes the pose on the clipboard, onto the joints that it names or onto their partners. */
export async function pastePose(editor: Editor, isMirrored: boolean): Promise<void> {
  const text = (await clipboardText())?.trim();
  if (text?.startsWith('{')) pasteText(editor, text, isMirrored);
  else editor.notice.value = 'There is no pose on the clipboard';
}

/** Puts the joints that a text of POSE.json names into its pose; the others stay as shown. */
export function pasteText(editor: Editor, text: string, isMirrored: boolean): void {
  const { store, session, evaluations, notice } = editor;
  const shown = evaluations.selected();
  if (!shown) {
    notice.value = 'There is no character to pose';
    return;
  }
  const { state, poseToEdit } = shown;
  const { skeleton } = state.character;
  const symmetry = symmetryOf(skeleton);
  const all = Array.from(skeleton.parents.keys());
  // What the text does not name of a joint then stays as it is.
  const onto = isMirrored
    ? mirrorJoints(symmetry, poseToEdit.q, poseToEdit.q, all).q
    : poseToEdit.q;
  if (isMotionText(text)) {
    pasteMotion(editor, text);
    return;
  }
  const { value, diagnostics } = readPoseJson('pasted pose', text, skeleton, onto);
  session.problems.value = diagnostics;
  const problems = diagnostics.length > 0 ? '; Problems says what was not used' : '';
  if (!value || hasErrors(diagnostics)) {
    notice.value = 'The pose was not pasted; Problems says why';
    return;
  }
  if (!isMirrored) {
    store.dispatch(setPose(state.id, value.q, 'Paste the pose'));
    notice.value = `Pose pasted${problems}`;
    return;
  }
  const mirrored = mirrorJoints(symmetry, value.q, poseToEdit.q, namedJoints(text, skeleton));
  store.dispatch(setPose(state.id, mirrored.q, 'Paste the pose mirrored'));
  notice.value = `Pose pasted mirrored${mirrorRemarks(mirrored)}${problems}`;
}

/** A motion belongs to a character as a whole, so that it is pasted as it is. */
function pasteMotion(editor: Editor, text: string): void {
  const problems: Diagnostic[] = [];
  const bytes = new TextEncoder().encode(text);
  editor.notice.value = openMotion(editor, 'pasted', bytes, problems);
  editor.session.problems.value = problems;
}

/** The joints of a text that was read as a pose. */
function namedJoints(text: string, skeleton: Skeleton): readonly number[] {
  const { joints = {}, root } = JSON.parse(text) as PoseJson;
  const named = Object.keys(joints).map((name) => findJoint(skeleton, name));
  const found = named.filter((joint) => typeof joint === 'number');
  if (root) found.push(firstRoot(skeleton));
  return [...new Set(found)].filter((joint) => joint !== noParent);
}
