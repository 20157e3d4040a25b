import type { GUI } from 'lil-gui';
import type { BoneDrag } from '../../document/session.ts';
import type { Editor } from '../editor.ts';
import { watch } from '../watch.ts';
import { addCommandRow } from './command-row.ts';
import { signalField } from './signal-field.ts';

/** Adds controls for what dragging a limb does. */
export function addBoneFolder(gui: GUI, editor: Editor): void {
  const { boneDrag } = editor.session;
  const folder = gui.addFolder('Dragging').close();
  const ways: Record<string, BoneDrag> = {
    'follows the pointer': 'follow',
    'as in CS354': 'course',
  };
  const way = folder.add(signalField(boneDrag), 'value', ways).name('Dragging');
  addCommandRow(folder, editor, 'bone-mode');
  watch([boneDrag], () => void way.updateDisplay());
}
