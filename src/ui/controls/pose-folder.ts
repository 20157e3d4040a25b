import type { GUI } from 'lil-gui';
import type { Editor } from '../editor.ts';
import { addCommandRow } from './command-row.ts';

/** Adds the commands for the selected character's whole pose, two in a row. */
export function addPoseFolder(gui: GUI, editor: Editor): void {
  const folder = gui.addFolder('Pose');
  addCommandRow(folder, editor, 'reset-pose');
  addCommandRow(folder, editor, 'copy-pose');
  addCommandRow(folder, editor, 'open-pose');
  addCommandRow(folder, editor, 'save-pose');
  addCommandRow(folder, editor, 'export-mesh');
}
