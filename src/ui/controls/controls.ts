import GUI from 'lil-gui';
// lil-gui's package does not export its style; injecting it would be an innerHTML write.
import '../../../node_modules/lil-gui/dist/lil-gui.min.css';
import type { Editor } from '../editor.ts';
import { addBoneFolder } from './bone-folder.ts';
import { addLightsFolder } from './lights-folder.ts';
import { addMorphFolder } from './morph-folder.ts';
import { addPictureFolder } from './picture-folder.ts';
import { addPlaceFolder } from './place-folder.ts';
import { addPoseFolder } from './pose-folder.ts';
import { addSliderRoles } from './slider-role.ts';
import { addSkinFolder } from './skin-folder.ts';
import { addViewFolder } from './view-folder.ts';

/** Every folder of the controls, from top to bottom. A new one is a file and a line here. */
const folders: readonly ((gui: GUI, editor: Editor) => void)[] = [
  addPoseFolder,
  addMorphFolder,
  addBoneFolder,
  addPlaceFolder,
  addSkinFolder,
  addViewFolder,
  addLightsFolder,
  addPictureFolder,
];

/** Every number and switch, in lil-gui. */
export function createControls(container: HTMLElement, editor: Editor): void {
  const gui = new GUI({ container, injectStyles: false, title: 'Controls' });
  for (const add of folders) add(gui, editor);
  addSliderRoles(gui);
}
