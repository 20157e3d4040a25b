import { zipSync } from 'fflate';
import { Failure, loadPart } from '../core/failure.ts';
import { insertPngText } from '../formats/png/text-chunk.ts';
import { GpuLimitError } from '../gl/gpu.ts';
import type { Editor, PictureTarget } from '../ui/editor.ts';
import { pictureRequest } from '../ui/picture-request.ts';
import { shownShot } from '../ui/shots.ts';
import type { DrawOver } from '../view/picture/draw-over.ts';
import { encodePicture } from '../view/picture/encode-picture.ts';
import { makePasses, passImages } from '../view/picture/make-passes.ts';
import {
  makePicture,
  type PictureRequest,
  type PictureWork,
} from '../view/picture/make-picture.ts';
import { tilesOf } from '../view/picture/picture-tiles.ts';
import { download } from '../ui/download.ts';
import { pictureKeyword } from './picture-note.ts';
import type { SceneParts } from './scenes/scene-parts.ts';
import { sceneText } from './scenes/scene-text.ts';

/** Saves or copies a picture of the view or of the shot that is shown, and says so. */
export async function savePicture(
  editor: Editor,
  parts: SceneParts,
  target: PictureTarget,
): Promise<void> {
  const { viewer, notice } = editor;
  if (!viewer.available.value) {
    notice.value = 'There is no view to take a picture of at the moment';
    return;
  }
  const loadLabels = () => loadPart(import('../ui/deform-lab/picture-labels.ts'));
  const labels = editor.session.comparison.peek() && (await loadLabels());
  const request = pictureRequest(editor);
  const drawOver = labels?.pictureLabels(editor, viewer.camera.peek(), request.size);
  // The scene is read now, so that it is that of the picture even if a clip plays meanwhile.
  const note = sceneText(parts);
  const name = nameOf(editor);
  const make = async (work: PictureWork): Promise<string> => {
    const drawn = { ...work, drawOver };
    const { blob, extension } = await pictureFile(editor, request, target, note, drawn);
    if (target === 'clipboard') return copyPicture(blob);
    if (target === 'file') {
      download(`${name}.${extension}`, blob, blob.type);
      return 'Picture saved';
    }
    const passes = await makePasses(viewer, passImages, request, work);
    const files: Record<string, Uint8Array> = {
      [`${name}.${extension}`]: new Uint8Array(await blob.arrayBuffer()),
    };
    for (const [id, png] of passes) files[`${name}-${id}.png`] = png;
    // The files of an archive are compressed already.
    download(`${name}-passes.zip`, zipSync(files, { level: 0 }), 'application/zip');
    return 'Picture and passes saved';
  };
  if (target !== 'passes' && tilesOf(request.size, request.samples).length === 1) {
    notice.value = await make({});
    return;
  }
  const done = await editor.whileWorking('Picture', (signal, onProgress) => {
    const { width, height } = request.size;
    const label = `${width} × ${height}`;
    return make({ signal, onProgress: (fraction) => onProgress(label, fraction) });
  });
  if (done !== undefined) notice.value = done;
}

interface PictureFile {
  readonly blob: Blob;
  readonly extension: string;
}

async function pictureFile(
  { viewer, picture: { value: settings } }: Editor,
  request: PictureRequest,
  target: PictureTarget,
  note: string,
  work: PictureWork & { readonly drawOver: DrawOver | null | undefined },
): Promise<PictureFile> {
  // A browser's clipboard takes PNG alone.
  const format = target === 'clipboard' ? 'png' : settings.format;
  // JPEG has no transparency.
  const showSurroundings = request.showSurroundings || format === 'jpeg';
  try {
    const picture = await makePicture(viewer, { ...request, showSurroundings }, work);
    const blob = await encodePicture(picture, format, work.drawOver);
    const extension = format === 'jpeg' ? 'jpg' : format;
    if (format !== 'png') return { blob, extension };
    return { blob: await withNote(blob, note), extension };
  } catch (error) {
    if (!(error instanceof GpuLimitError)) throw error;
    throw new Failure(`No picture: ${error.message}`, { cause: error });
  }
}

/** A shot's picture has its name, beside that of the selected character. */
function nameOf(editor: Editor): string {
  const name = editor.evaluations.selected()?.state.name ?? 'sinew';
  const shot = shownShot(editor);
  return shot ? `${name}-${shot.name}` : name;
}

async function withNote(png: Blob, note: string): Promise<Blob> {
  const bytes = insertPngText(new Uint8Array(await png.arrayBuffer()), pictureKeyword, note);
  return new Blob([bytes as BlobPart], { type: 'image/png' });
}

async function copyPicture(blob: Blob): Promise<string> {
  try {
    await navigator.clipboard.write([new ClipboardItem({ [blob.type]: blob })]);
    return 'Picture copied';
  } catch {
    return 'The browser did not let the picture be copied';
  }
}
