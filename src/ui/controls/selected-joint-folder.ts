import { effect } from '@preact/signals-core';
import type { GUI } from 'lil-gui';
import { selectedJoints } from '../../document/selected-joints.ts';
import type { Editor } from '../editor.ts';
import { gimbalText } from '../gimbal-text.ts';
import { addCommandRow } from './command-row.ts';
import { addJointValues, jointName, type JointValueRow } from './joint-values.ts';
import { addNote } from './note.ts';
import { addPartnerNote } from './partner-note.ts';
import { rotationOrder } from './rotation-order.ts';

/** Adds the numbers of the selected joint, and the way to the next one. Returns what ends it. */
export function addSelectedJointFolder(gui: GUI, editor: Editor): () => void {
  const { session, evaluations } = editor;
  const folder = gui.addFolder('Joint');
  folder.domElement.classList.add('selected-joint');
  addCommandRow(folder, editor, 'previous-joint');
  addCommandRow(folder, editor, 'next-joint');
  let values: GUI | null = null;
  let rows: readonly JointValueRow[] = [];
  /** Says where two of its angles turn about one axis. */
  let lock: HTMLElement | null = null;
  /** The character, the actor and the joint whose rows there are. */
  let shown: readonly unknown[] = [];

  return effect(() => {
    const state = evaluations.selected()?.state;
    const joint = session.selectedJoint.value;
    const others = Math.max(0, selectedJoints(session).length - 1);
    const next = [state?.character, state?.id ?? null, joint, others] as const;
    if (next.some((part, index) => part !== shown[index])) {
      shown = next;
      values?.destroy();
      values = folder.addFolder('');
      values.domElement.classList.add('plain');
      const isAny = state !== undefined && joint !== null;
      const more = others === 0 ? '' : ` and ${others} more`;
      folder.title(isAny ? `${jointName(state, joint)}${more}` : 'Joint');
      lock = null;
      rows = isAny ? addJointValues(values, editor, state, joint) : [];
      if (!isAny) addNote(values, 'Click a limb, or choose a joint in the list.');
      else if (rows.length === 0) addNote(values, 'It has no degrees of freedom.');
      else {
        values.domElement.dataset['joint'] = String(joint);
        lock = addNote(values, '');
        addNote(values, rotationOrder(state.character.skeleton));
        addPartnerNote(values, editor, state.character.skeleton, joint);
        addCommandRow(values, editor, 'set-key');
        addCommandRow(values, editor, 'pin');
        addCommandRow(values, editor, 'reset-joint');
        addCommandRow(values, editor, 'reset-branch');
      }
    }
    if (lock) {
      lock.textContent = gimbalText(editor);
      lock.hidden = lock.textContent === '';
    }
    for (const row of rows) row.refresh();
  });
}
