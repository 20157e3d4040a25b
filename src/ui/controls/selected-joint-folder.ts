import { effect } from '@preact/signals-core';
import type { GUI } from 'lil-gui';
import type { Editor } from '../editor.ts';
import { addCommandRow } from './command-row.ts';
import { addJointValues, jointName, type JointValueRow } from './joint-values.ts';
import { addNote } from './note.ts';
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
  /** The character, the actor and the joint whose rows there are. */
  let shown: readonly unknown[] = [];

  return effect(() => {
    const state = evaluations.selected()?.state;
    const joint = session.selectedJoint.value;
    const next = [state?.character, state?.id ?? null, joint] as const;
    if (next.some((part, index) => part !== shown[index])) {
      shown = next;
      values?.destroy();
      values = folder.addFolder('');
      values.domElement.classList.add('plain');
      const isAny = state !== undefined && joint !== null;
      folder.title(isAny ? jointName(state, joint) : 'Joint');
      rows = isAny ? addJointValues(values, editor, state, joint) : [];
      if (!isAny) addNote(values, 'Click a limb, or choose a joint in the list.');
      else if (rows.length === 0) addNote(values, 'It has no degrees of freedom.');
      else {
        values.domElement.dataset['joint'] = String(joint);
        addNote(values, rotationOrder(state.character.skeleton));
        addCommandRow(values, editor, 'reset-joint');
      }
    }
    for (const row of rows) row.refresh();
  });
}
