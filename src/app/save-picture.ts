import type { Evaluation } from '../evaluation/evaluation.ts';
import { insertPngText } from '../formats/png/text-chunk.ts';
import { poseToJson } from '../formats/write-pose-json.ts';
import { GpuLimitError } from '../gl/gpu.ts';
import type { PictureOptions } from '../ui/editor.ts';
import { capturePicture, encodePicture } from '../view/picture.ts';
import type { Viewer } from '../view/viewer.ts';
import { download } from './download.ts';
import { pictureKeyword, writePictureNote } from './picture-note.ts';

/** Saves or copies a picture of the view, and returns a message about the result for the user. */
export async function savePicture(
  viewer: Viewer,
  shown: Evaluation | undefined,
  { format, size, background, target }: PictureOptions,
): Promise<string> {
  if (!viewer.available.value) return 'There is no view to take a picture of at the moment';
  // The pose is read now, so that it matches the picture even if a clip plays while the picture is
  // encoded.
  const note = shown && noteOf(shown);
  let blob: Blob;
  try {
    // JPEG has no transparency.
    const picture = capturePicture(viewer, size, background || format === 'jpeg');
    blob = await encodePicture(picture, format);
  } catch (error) {
    if (!(error instanceof GpuLimitError)) throw error;
    return error.message;
  }
  if (format === 'png' && note !== undefined) blob = await withNote(blob, note);
  if (target === 'clipboard') return copyPicture(blob);
  const extension = format === 'jpeg' ? 'jpg' : format;
  download(`${shown?.state.name ?? 'sinew'}.${extension}`, blob, blob.type);
  return 'Picture saved';
}

function noteOf({ state: { character, source }, pose }: Evaluation): string {
  return writePictureNote({
    ...(source.kind === 'bundled' ? { bundled: source.id } : {}),
    name: character.name,
    pose: poseToJson(character.skeleton, pose),
  });
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
