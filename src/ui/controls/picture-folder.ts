import type { GUI } from 'lil-gui';
import type { PictureFormat } from '../../view/picture.ts';
import { attempt } from '../attempt.ts';
import type { Actions, PictureOptions, Telling } from '../editor.ts';

/**
 * Adds controls for saving a picture of exactly what the view shows, or of the same view at any
 * size.
 */
export function addPictureFolder(gui: GUI, editor: Actions & Telling): void {
  const folder = gui.addFolder('Picture').close();
  const bound = {
    format: 'png' as PictureFormat,
    size: 'view' as 'view' | 'exact',
    width: 1920,
    height: 1080,
    background: true,
    save: () => attempt(editor, editor.savePicture(options('file'))),
    copy: () => attempt(editor, editor.savePicture({ ...options('clipboard'), format: 'png' })),
  };
  const options = (target: PictureOptions['target']): PictureOptions => ({
    format: bound.format,
    background: bound.background,
    target,
    ...(bound.size === 'exact' ? { size: { width: bound.width, height: bound.height } } : {}),
  });
  folder.add(bound, 'format', { PNG: 'png', JPEG: 'jpeg' }).name('Format');
  folder
    .add(bound, 'size', { 'As the view': 'view', 'Width × height': 'exact' })
    .name('Size')
    .onChange(showSize);
  const sizes = [
    folder.add(bound, 'width', 16, 8192, 1).name('Width'),
    folder.add(bound, 'height', 16, 8192, 1).name('Height'),
  ];
  folder.add(bound, 'background').name('Background');
  folder.add(bound, 'save').name('Save (j)');
  folder.add(bound, 'copy').name('Copy');
  showSize();

  function showSize(): void {
    for (const size of sizes) size.show(bound.size === 'exact');
  }
}
