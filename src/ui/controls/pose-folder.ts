import { effect } from '@preact/signals-core';
import type { GUI } from 'lil-gui';
import { selectedActor } from '../../document/selected-actor.ts';
import type { PoseScope } from '../../document/session.ts';
import { jointPairs, noPartner } from '../../posing/symmetry/joint-pairs.ts';
import type { Editor } from '../editor.ts';
import { addCommandRow } from './command-row.ts';
import { addNote } from './note.ts';
import { signalField } from './signal-field.ts';

const scopes: Readonly<Record<string, PoseScope>> = {
  'Whole body': 'whole',
  Branch: 'branch',
  'Selected joints': 'selected',
};
/** A list of more names is shortened. */
const mostNames = 8;

/**
 * Adds the commands for the selected character's pose, two in a row, and its symmetry. Returns what
 * ends its effects.
 */
export function addPoseFolder(gui: GUI, editor: Editor): () => void {
  const { session } = editor;
  const folder = gui.addFolder('Pose');
  addCommandRow(folder, editor, 'copy-pose');
  addCommandRow(folder, editor, 'paste-pose');
  addCommandRow(folder, editor, 'paste-mirrored');
  addCommandRow(folder, editor, 'mirror-pose');
  addCommandRow(folder, editor, 'left-onto-right');
  addCommandRow(folder, editor, 'right-onto-left');
  const scope = folder.add(signalField(session.poseScope), 'value', scopes).name('Applies to');
  scope.domElement.title = 'The joints that are copied and mirrored, of those that are selected';
  addCommandRow(folder, editor, 'live-symmetry');
  const alone = addNote(folder, '');
  addCommandRow(folder, editor, 'reset-pose');
  addCommandRow(folder, editor, 'export-mesh');
  addCommandRow(folder, editor, 'open-pose');
  addCommandRow(folder, editor, 'save-pose');
  return effect(() => {
    const isOff = session.selectedJoint.value === null;
    scope.disable(isOff).updateDisplay();
    // The list itself is unseen; what shows its value has to say so too.
    scope.domElement.setAttribute('aria-disabled', String(isOff));
    alone.textContent = aloneText(editor);
    alone.hidden = alone.textContent === '';
  });
}

/** The joints of the selected character that no other joint mirrors. */
function aloneText({ store, session }: Editor): string {
  const skeleton = selectedActor(store, session)?.character.skeleton;
  if (!skeleton) return '';
  const { partners } = jointPairs(skeleton);
  const names = skeleton.names.filter((_, joint) => partners[joint] === noPartner);
  if (names.length === 0) return '';
  if (names.length === skeleton.jointCount) return 'No left and right were found.';
  const more = names.length - mostNames;
  const shown = more > 1 ? [...names.slice(0, mostNames), `${more} more`] : names;
  return `Without partner: ${shown.join(', ')}.`;
}
