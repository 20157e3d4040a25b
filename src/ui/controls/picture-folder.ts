import type { GUI } from 'lil-gui';
import { lossyQuality, type PictureFormat } from '../../view/picture/encode-picture.ts';
import type { PictureSettings, PictureSizeId } from '../../view/picture/picture-size.ts';
import type { Editor } from '../editor.ts';
import { pictureRequest } from '../picture-request.ts';
import { watch } from '../watch.ts';
import { addCommandRow } from './command-row.ts';
import { addNote } from './note.ts';
import { field } from './signal-field.ts';

const quality = `, at a quality of ${Math.round(lossyQuality * 100)} %`;
const formats: Readonly<Record<string, PictureFormat>> = {
  PNG: 'png',
  JPEG: 'jpeg',
  WebP: 'webp',
};
const sizes: Readonly<Record<string, PictureSizeId>> = {
  'As the view': 'view',
  '1080p': '1080p',
  '4K': '4k',
  'A4, 300 dpi': 'a4',
  'Width × height': 'free',
};
const samples: Readonly<Record<string, number>> = {
  'As the view': 1,
  '2 × 2': 2,
  '3 × 3': 3,
  '4 × 4': 4,
};

/** Adds controls for pictures of exactly what the view or its frame shows, at any size. */
export function addPictureFolder(gui: GUI, editor: Editor): void {
  const { picture, viewer, session, store } = editor;
  const folder = gui.addFolder('Picture').close();
  const setting = <Key extends keyof PictureSettings>(key: Key) =>
    field(
      () => picture.value[key],
      (value) => (picture.value = { ...picture.value, [key]: value }),
    );
  const rows = [
    folder.add(setting('format'), 'value', formats).name('Format'),
    folder.add(setting('size'), 'value', sizes).name('Size'),
    folder.add(setting('samples'), 'value', samples).name('Samples a pixel'),
    folder.add(setting('background'), 'value').name('Background'),
  ];
  const width = folder.add(setting('width'), 'value', 16, 16_384, 1).name('Width');
  const height = folder.add(setting('height'), 'value', 16, 16_384, 1).name('Height');
  const note = addNote(folder, '');
  addCommandRow(folder, editor, 'save-picture');
  addCommandRow(folder, editor, 'copy-picture');
  addCommandRow(folder, editor, 'save-passes');
  const { size, camera, framing } = viewer;
  watch([picture, size, camera, framing, session.shownShot, store.scene], () => {
    for (const row of [...rows, width, height]) row.updateDisplay();
    const isFree = picture.value.size === 'free';
    width.show(isFree);
    height.show(isFree && framing.value === null);
    const wanted = pictureRequest(editor).size;
    const isLossy = picture.value.format !== 'png';
    note.textContent = `${wanted.width} × ${wanted.height} pixels${isLossy ? quality : ''}`;
  });
}
