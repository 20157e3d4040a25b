import { effect } from '@preact/signals-core';
import type { GUI } from 'lil-gui';
import { selectedActor } from '../../document/selected-actor.ts';
import { ikMethod, ikMethods } from '../../posing/ik/methods.ts';
import { chainLengthOf } from '../chain-length.ts';
import type { Editor } from '../editor.ts';
import { addCommandRow } from './command-row.ts';
import { addNaturalRows } from './natural-rows.ts';
import { addNote } from './note.ts';
import { field, signalField } from './signal-field.ts';

/** Adds the controls of inverse kinematics. Returns what ends its effects. */
export function addIkFolder(gui: GUI, editor: Editor): () => void {
  const { store, session } = editor;
  const folder = gui.addFolder('Inverse kinematics').close();
  addCommandRow(folder, editor, 'ik-mode');
  const methods = Object.fromEntries(ikMethods.map(({ id, label }) => [label, id]));
  folder.add(signalField(session.ikMethod), 'value', methods).name('Solver');
  const summary = addNote(folder, '');
  const length = field(
    () => lengthNow().count,
    (count) => {
      const joint = session.selectedJoint.value;
      if (joint !== null) session.chainLength.value = { joint, count };
    },
  );
  const chain = folder.add(length, 'value', 1, 1, 1).name('Joints in the chain');
  addCommandRow(folder, editor, 'longer-chain');
  addCommandRow(folder, editor, 'shorter-chain');
  const targets = folder.add(signalField(session.showTargets), 'value').name("The file's targets");
  const endNatural = addNaturalRows(folder, editor);
  const endChain = effect(() => {
    summary.textContent = ikMethod(session.ikMethod.value).summary;
    targets.show((selectedActor(store, session)?.character.ikChains.length ?? 0) > 0);
    const { most } = lengthNow();
    chain
      .max(most)
      .show(session.selectedJoint.value !== null)
      .updateDisplay();
  });
  return () => {
    endNatural();
    endChain();
  };

  function lengthNow() {
    const joint = session.selectedJoint.value;
    return joint === null ? { count: 1, most: 1 } : chainLengthOf(editor, joint);
  }
}
