import GUI from 'lil-gui';
// lil-gui's package does not export its style sheet, and injecting it would write innerHTML.
import '../../../node_modules/lil-gui/dist/lil-gui.min.css';
import type { Editor } from '../editor.ts';
import { addBoneFolder } from './bone-folder.ts';
import { addLookFolder } from './look-folder.ts';
import { addLightsFolder } from './lights-folder.ts';
import { addMorphFolder } from './morph-folder.ts';
import { addPictureFolder } from './picture-folder.ts';
import { addPlaceFolder } from './place-folder.ts';
import { addPoseFolder } from './pose-folder.ts';
import { addSliderRoles } from './slider-role.ts';
import { addSkinFolder } from './skin-folder.ts';
import { addViewFolder } from './view-folder.ts';

/**
 * Every folder of the controls, from top to bottom. To add one, write a file and add a line here.
 */
const folders: readonly ((gui: GUI, editor: Editor) => void)[] = [
  addPoseFolder,
  addMorphFolder,
  addBoneFolder,
  addPlaceFolder,
  addLookFolder,
  addSkinFolder,
  addViewFolder,
  addLightsFolder,
  addPictureFolder,
];

/** Creates the controls for all numbers and switches, with lil-gui. */
export function createControls(container: HTMLElement, editor: Editor): void {
  const gui = new GUI({ container, injectStyles: false, title: 'Controls' });
  for (const add of folders) add(gui, editor);
  addSliderRoles(gui);
}
