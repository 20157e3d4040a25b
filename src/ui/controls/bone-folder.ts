import type { GUI } from 'lil-gui';
import type { BoneDrag } from '../../document/session.ts';
import type { Looking } from '../editor.ts';
import { signalField } from './signal-field.ts';
import { watch } from '../watch.ts';

/** What dragging does in the view. */
export function addBoneFolder(gui: GUI, { session }: Looking): void {
  const { boneMode, boneDrag, firstPerson } = session;
  const folder = gui.addFolder('Drag');
  const ways: Record<string, BoneDrag> = {
    'Under the pointer': 'follow',
    'As CS354’s program': 'course',
  };
  const rows = [
    folder.add(signalField(boneMode), 'value').name('Bone mode (m)'),
    folder.add(signalField(boneDrag), 'value', ways).name('A bone turns'),
    folder.add(signalField(firstPerson), 'value').name('First person (c)'),
  ];
  watch([boneMode, boneDrag, firstPerson], () => {
    for (const row of rows) row.updateDisplay();
  });
}
