import { ratioOf } from '../document/shots.ts';
import type { PictureRequest } from '../view/picture/make-picture.ts';
import { pictureSizeOf } from '../view/picture/picture-size.ts';
import type { Looking, PageState } from './editor.ts';
import { shotFrameOf, shownShot } from './shots.ts';

/** What a picture is of by the present settings: the view, or the inside of a shot's frame. */
export function pictureRequest(editor: Looking & Pick<PageState, 'picture'>): PictureRequest {
  const { viewer } = editor;
  const settings = editor.picture.value;
  const { width, height } = shotFrameOf(viewer);
  const { contents, columns } = viewer;
  const view = viewer.size.value;
  const framed = { width: (view.width * width) / columns, height: view.height * height };
  const size = pictureSizeOf(settings, framed, ratioOf(shownShot(editor)));
  return {
    size: { ...size, width: size.width * columns },
    contents: contents.map((content) => ({ ...content, camera: viewer.camera.value })),
    showSurroundings: settings.background,
    samples: settings.samples,
  };
}
