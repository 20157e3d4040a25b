import type { GUI } from 'lil-gui';
import type { PictureFormat } from '../../view/picture.ts';
import type { Editor } from '../editor.ts';

/** A picture of exactly what the view shows. */
export function addPictureFolder(gui: GUI, editor: Editor): void {
  const folder = gui.addFolder('Picture');
  const bound = {
    format: 'png' as PictureFormat,
    save: () => void editor.savePicture(bound.format),
  };
  folder.add(bound, 'format', { PNG: 'png', JPEG: 'jpeg' }).name('Format');
  folder.add(bound, 'save').name('Save picture (j)');
}
