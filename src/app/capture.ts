import { ratioOf, type Shot } from '../document/shots.ts';
import { pictureLabels } from '../ui/deform-lab/picture-labels.ts';
import type { Editor } from '../ui/editor.ts';
import { deformationOf } from '../skinning/registry.ts';
import { encodePicture } from '../view/picture/encode-picture.ts';
import { makePasses } from '../view/picture/make-passes.ts';
import { makePicture } from '../view/picture/make-picture.ts';
import type { ViewContent } from '../view/render-view.ts';
import type { CaptureSize } from '../view/viewer.ts';
import type { CaptureOptions } from './scripting.ts';

/** Returns a picture as a file, for scripts. */
export async function capture(editor: Editor, options: CaptureOptions): Promise<Blob> {
  const { viewer } = editor;
  const { format = 'png', background = true, samples = 1, pass, tileLimit } = options;
  const shot = options.shot === undefined ? undefined : shotNamed(editor, options.shot);
  const request = {
    size: sizeOf(viewer.size.value, options, shot),
    contents: contentsOf(editor, options, shot),
    ...(tileLimit !== undefined && { tileLimit }),
  };
  if (pass) {
    const images = await makePasses(viewer, [pass], request);
    return new Blob([images.get(pass) as BlobPart], { type: 'image/png' });
  }
  // Views of one's own are no comparison.
  const isLabeled = options.labels === true && !options.views && !shot;
  const labels = isLabeled ? pictureLabels(editor, viewer.viewCamera.value, request.size) : null;
  const showSurroundings = background || format === 'jpeg'; // which has no transparency
  const picture = await makePicture(viewer, { ...request, showSurroundings, samples });
  return encodePicture(picture, format, labels);
}

function shotNamed({ store }: Editor, name: number | string): Shot {
  const shots = store.scene.value.shots;
  const found = shots.find((shot) => shot.id === name || shot.name === name);
  if (!found) throw new Error(`there is no shot ${JSON.stringify(name)}`);
  return found;
}

/** The size of the view, if no other is given; a shot keeps its aspect at either side. */
function sizeOf(
  view: CaptureSize,
  { width, height }: CaptureOptions,
  shot: Shot | undefined,
): CaptureSize {
  const ratio = ratioOf(shot);
  if (ratio === null) return width !== undefined && height !== undefined ? { width, height } : view;
  if (width !== undefined) return { width, height: height ?? Math.round(width / ratio) };
  const side = height ?? view.height;
  return { width: Math.round(side * ratio), height: side };
}

function contentsOf(
  { viewer }: Editor,
  { views }: CaptureOptions,
  shot: Shot | undefined,
): readonly ViewContent[] {
  if (shot) return [{ camera: shot.camera, overrides: {} }];
  if (!views) return viewer.contents;
  return views.map(({ camera, method }) => ({
    camera: { ...viewer.viewCamera.value, ...camera },
    overrides: method === undefined ? {} : { deformation: deformationOf(method) },
  }));
}
