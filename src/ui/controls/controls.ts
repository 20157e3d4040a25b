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

/** Every number and switch, in lil-gui. */
export function createControls(container: HTMLElement, editor: Editor): void {
  const gui = new GUI({ container, injectStyles: false, title: 'Controls' });
  addPoseFolder(gui, editor);
  addMorphFolder(gui, editor);
  addBoneFolder(gui, editor);
  addPlaceFolder(gui, editor);
  addSkinFolder(gui, editor);
  addViewFolder(gui, editor);
  addLightsFolder(gui, editor);
  addPictureFolder(gui, editor);
  addSliderRoles(gui);
}
