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
  const canvas = document.createElement('canvas');
  canvas.width = Math.max(640, 2 * margin + methods.length * (side + gap) - gap);
  canvas.height = margin + head + rows.length * rowHeight + margin;
  const context = canvas.getContext('2d');
  assert(context !== null, 'a canvas that draws');
  context.fillStyle = colors.paper;
  context.fillRect(0, 0, canvas.width, canvas.height);
  const write = (text: string, x: number, y: number, style: string, color = colors.text): void => {
    context.font = `${style} ${font}`;
    context.fillStyle = color;
    context.fillText(text, x, y, canvas.width - margin - x);
  };
  write(`Stress suite of ${suite.name}`, margin, margin + 24, '650 26px');
  const from = `Largest difference from ${kernelById(methods[base]!).label}`;
  write(
    `${from}, in units of the file (per cent of the height)`,
    margin,
    margin + 54,
    '16px',
    colors.quiet,
  );
  const left = (index: number): number => margin + index * (side + gap);
  methods.forEach((method, index) => {
    context.save();
    context.beginPath();
    context.rect(left(index), 0, side, canvas.height);
    context.clip();
    write(kernelById(method).label, left(index), margin + head - 14, '600 18px');
    context.restore();
  });
  rows.forEach((row, at) => {
    const top = margin + head + at * rowHeight;
    write(stressLabel(actor.character.skeleton, row.pose), margin, top + 28, '600 18px');
    methods.forEach((_, index) => {
      const x = left(index);
      context.fillStyle = colors.tile;
      context.fillRect(x, top + labelHeight, side, side);
      context.drawImage(canvasOf(drawn.get(row)![index]!), x, top + labelHeight);
      const { largest, volume } = row.numbers[index]!;
      const bottom = top + labelHeight + side;
      write(index === base ? 'base' : differenceText(largest, size), x, bottom + 20, '16px');
      if (volume === null) return;
      write(`volume ${volume.toFixed(3)}`, x, bottom + 40, '16px', colors.quiet);
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
