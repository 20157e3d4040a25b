import type { GUI } from 'lil-gui';
import type { BoneDrag } from '../../document/session.ts';
import type { Editor } from '../editor.ts';
import { addCommandRow } from './command-row.ts';
import { signalField } from './signal-field.ts';
import { watch } from '../watch.ts';

/** Controls for what dragging does in the view. */
export function addBoneFolder(gui: GUI, editor: Editor): void {
  const { boneDrag } = editor.session;
  const folder = gui.addFolder('Drag');
  const ways: Record<string, BoneDrag> = {
    'Under the pointer': 'follow',
    'As CS354’s program': 'course',
  };
  addCommandRow(folder, editor, 'bone-mode');
  const way = folder.add(signalField(boneDrag), 'value', ways).name('A bone turns');
  addCommandRow(folder, editor, 'first-person');
  watch([boneDrag], () => void way.updateDisplay());
}
