import { assert } from '../../core/assert.ts';
import { Failure } from '../../core/failure.ts';
import type { StressRow } from '../../evaluation/comparison/stress.ts';
import { stressLabel } from '../../evaluation/comparison/stress-rows.ts';
import { kernelById } from '../../skinning/registry.ts';
import type { Picture } from '../../view/picture/encode-picture.ts';
import { download } from '../download.ts';
import type { Editor } from '../editor.ts';
import { differenceText } from './difference-text.ts';
import { type MeasuredSuite, stressLabOf } from './stress-lab.ts';

/** Lengths in pixels of the picture. */
const margin = 32;
const gap = 12;
const head = 118;
const labelHeight = 44;
const figureHeight = 50;
const leastWidth = 720;
const font = 'system-ui, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif';
/** For paper, whatever the theme of the page is. */
const colors = { paper: '#ffffff', tile: '#f1f2f4', text: '#22252a', quiet: '#596068' };

/**
 * Saves the pictures of the suite as one, with labels, the figures and a light background, so that it
 * can stand in a report. The poses are in the order of the page.
 */
export async function saveStressPictures(editor: Editor): Promise<void> {
  const lab = stressLabOf(editor);
  const suite = lab.measurement.result.peek();
  const drawn = lab.pictures.drawn.peek();
  const rows = lab.rows.peek().filter((row) => drawn.has(row));
  if (!suite || rows.length === 0) {
    editor.notice.value = 'The stress suite has no pictures yet';
    return;
  }
  const canvas = stripOf(suite, rows, drawn);
  const png = await new Promise<Blob | null>((done) => canvas.toBlob(done, 'image/png'));
  if (!png) throw new Failure('The browser could not make a picture of the stress suite');
  download(`${suite.name}-stress.png`, png, png.type);
  editor.notice.value = `Pictures of ${rows.length} poses saved`;
}

function stripOf(
  suite: MeasuredSuite,
  rows: readonly StressRow[],
  drawn: ReadonlyMap<StressRow, readonly Picture[]>,
): HTMLCanvasElement {
  const { methods, base, size, actor } = suite;
  const [{ width: side }] = drawn.get(rows[0]!) as [Picture];
  const rowHeight = labelHeight + side + figureHeight + gap;
  const blockWidth = methods.length * (side + gap) + 2 * gap;
  // Several poses beside each other, so that the picture fits a page.
  const across = Math.max(1, Math.round(Math.sqrt((rows.length * rowHeight) / (1.4 * blockWidth))));
  const down = Math.ceil(rows.length / across);
  const canvas = document.createElement('canvas');
  canvas.width = Math.max(leastWidth, 2 * margin + Math.ceil(rows.length / down) * blockWidth);
  canvas.height = margin + head + down * rowHeight + margin;
  const context = canvas.getContext('2d');
  assert(context !== null, 'a canvas that draws');
  context.fillStyle = colors.paper;
  context.fillRect(0, 0, canvas.width, canvas.height);
  const write = (text: string, x: number, y: number, style: string, width = side): void => {
    context.font = `${style} ${font}`;
    context.fillText(text, x, y, width);
  };
  const whole = canvas.width - 2 * margin;
  context.fillStyle = colors.text;
  write(`Stress suite of ${suite.name}`, margin, margin + 24, '650 26px', whole);
  context.fillStyle = colors.quiet;
  const from = `Largest difference from ${kernelById(methods[base]!).label}`;
  const units = 'in units of the file (per cent of the height); volume against rest';
  write(`${from}, ${units}`, margin, margin + 54, '16px', whole);
  rows.forEach((row, at) => {
    const left = margin + Math.floor(at / down) * blockWidth;
    const top = margin + head + (at % down) * rowHeight;
    context.fillStyle = colors.text;
    const label = stressLabel(actor.character.skeleton, row.pose);
    write(label, left, top + 28, '600 18px', blockWidth - 3 * gap);
    methods.forEach((method, index) => {
      const x = left + index * (side + gap);
      context.fillStyle = colors.text;
      if (at % down === 0) write(kernelById(method).label, x, top - 10, '600 18px');
      context.fillStyle = colors.tile;
      context.fillRect(x, top + labelHeight, side, side);
      context.drawImage(canvasOf(drawn.get(row)![index]!), x, top + labelHeight);
      const { largest, volume } = row.numbers[index]!;
      const bottom = top + labelHeight + side;
      context.fillStyle = colors.text;
      write(index === base ? 'base' : differenceText(largest, size), x, bottom + 20, '16px');
      context.fillStyle = colors.quiet;
      if (volume !== null) write(`volume ${volume.toFixed(3)}`, x, bottom + 40, '16px');
    });
  });
  return canvas;
}

function canvasOf({ width, height, pixels }: Picture): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [width, height];
  canvas.getContext('2d')?.putImageData(new ImageData(pixels, width, height), 0, 0);
  return canvas;
}
