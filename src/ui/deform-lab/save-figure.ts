import { assert } from '../../core/assert.ts';
import { Failure } from '../../core/failure.ts';
import { download } from '../download.ts';
import type { Looking, Telling } from '../editor.ts';
import { cuttingSettings } from './cutting-settings.ts';
import { viewOfJoint } from './figure-paths.ts';
import { figureSvg } from './figure-svg.ts';

export type FigureForm = 'svg' | 'png';

/** Pixels of a PNG for each of the drawing's. */
const pngScale = 4;

/** Saves the figure as it is shown, as a drawing or as a picture of it, and says so. */
export async function saveFigure(
  { session, notice }: Looking & Telling,
  form: FigureForm,
): Promise<void> {
  const settings = cuttingSettings(session);
  const figure = settings.figure.peek();
  if (!figure) return;
  const text = figureSvg(figure, settings.view.peek() ?? viewOfJoint(figure));
  const svg = new Blob([text], { type: 'image/svg+xml' });
  const file = form === 'svg' ? svg : await pictureOf(svg);
  download(`${figure.characterName}-${figure.jointName}-cut.${form}`, file, file.type);
  notice.value = 'Figure saved';
}

async function pictureOf(svg: Blob): Promise<Blob> {
  const url = URL.createObjectURL(svg);
  try {
    const image = new Image();
    image.src = url;
    await image.decode();
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [image.width * pngScale, image.height * pngScale];
    const context = canvas.getContext('2d');
    assert(context !== null, 'a canvas that draws');
    context.drawImage(image, 0, 0, canvas.width, canvas.height);
    const png = await new Promise<Blob | null>((done) => canvas.toBlob(done, 'image/png'));
    if (!png) throw new Failure('The browser could not make a picture of the figure');
    return png;
  } finally {
    URL.revokeObjectURL(url);
  }
}
