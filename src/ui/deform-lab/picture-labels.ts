import { printable } from '../../core/diagnostics.ts';
import type { Camera } from '../../document/camera.ts';
import { errorRamp, zeroColor } from '../../skinning/weights/ramps.ts';
import type { CaptureSize } from '../../view/viewer.ts';
import { cssColor } from '../css-color.ts';
import type { Looking } from '../editor.ts';
import { formatSize } from '../number-text.ts';
import { comparedOf } from './compared.ts';
import { differenceText, percentText } from './difference-text.ts';
import { heatScale } from './heat-scale.ts';
import { methodPlaces } from './method-places.ts';
import { placeOfWorst, viewPlace } from './place-of-worst.ts';

/** Draws over a finished picture. */
export type DrawOver = (context: CanvasRenderingContext2D) => void;

const [ink, paper, markColor] = ['#1b1f24', '#ffffffe0', '#b3126a'];
/** A picture of this size in pixels, or a view in it of this width, has text of `textSize`. */
const [plainHeight, plainWidth, textSize] = [480, 300, 13];
/** The text of a narrow view gets no smaller than this part of it. */
const smallest = 0.6;

/**
 * Returns what draws over a picture of the comparison that is shown now: the names of the methods, the
 * lines between them, the largest difference with its figure, and what the colors of a heat map mean.
 * It is null while nothing is compared.
 *
 * @param camera that of the picture, in each of its views
 */
export function pictureLabels(editor: Looking, camera: Camera, size: CaptureSize): DrawOver | null {
  const comparison = editor.session.comparison.peek();
  const compared = comparedOf(editor);
  if (!comparison || !compared) return null;
  const { width, height } = size;
  const columns = comparison.layout === 'wipe' ? 1 : comparison.methods.length;
  const unit = Math.max(1, Math.min(height / plainHeight, width / columns / plainWidth));
  const places = methodPlaces(comparison);
  const names = compared.rows.map(({ kernel }) => kernel.label);
  const worst = placeOfWorst(compared);
  const mark = worst && {
    text: differenceText(compared.worst!.difference.largest, compared.size),
    ends: [worst.base, worst.other].map((end) => viewPlace(camera, width / columns / height, end)),
  };
  const scale = comparison.heatMap && worst ? heatScale(compared) : 0;
  const ticks = [0, 0.5, 1].map((part) => {
    const value = part * scale;
    return `${formatSize(value)} (${percentText(value, compared.size)})`;
  });
  const { name } = compared.base.evaluation.state;
  const about = `Difference from ${compared.base.kernel.label} in units of ${printable(name, 40)}, and of its height`;

  return (context) => {
    context.textBaseline = 'middle';
    for (const [from] of places.slice(1)) {
      drawLine(
        context,
        [from * width, 0],
        [from * width, height],
        2 * unit,
        '#ffffff',
        '#00000066',
      );
    }
    if (mark) {
      for (let column = 0; column < columns; column++) {
        drawMark(context, mark, column, columns, unit);
      }
    }
    places.forEach(([from, to], index) => {
      const room = (to - from) * width - 8 * unit;
      if (room < 20 * unit) return;
      const y = 10 * unit + textSize * unit;
      drawChip(context, names[index]!, ((from + to) / 2) * width, y, unit, room);
    });
    if (scale > 0) drawLegend(context, about, ticks, unit);
  };
}

type Point = readonly [x: number, y: number];

function drawLine(
  context: CanvasRenderingContext2D,
  from: Point,
  to: Point,
  width: number,
  color: string,
  around: string,
): void {
  context.beginPath();
  context.moveTo(...from);
  context.lineTo(...to);
  for (const [lineWidth, strokeStyle] of [
    [2 * width, around],
    [width, color],
  ] as const) {
    Object.assign(context, { lineWidth, strokeStyle });
    context.stroke();
  }
}

/** Text in a box around a place, in smaller letters where it would be wider than its room. */
function drawChip(
  context: CanvasRenderingContext2D,
  text: string,
  x: number,
  y: number,
  unit: number,
  room: number,
  [color, back] = [ink, paper],
): void {
  setFont(context, textSize * unit);
  const padding = 7 * unit;
  const part = Math.min(1, (room - 2 * padding) / context.measureText(text).width);
  const size = textSize * unit * Math.max(smallest, part);
  setFont(context, size);
  const width = context.measureText(text).width + 2 * padding;
  drawBox(context, x - width / 2, y - 0.85 * size, width, 1.7 * size, back);
  context.textAlign = 'center';
  context.fillStyle = color!;
  context.fillText(text, x, y);
}

function drawMark(
  context: CanvasRenderingContext2D,
  { text, ends }: { readonly text: string; readonly ends: readonly Point[] },
  column: number,
  columns: number,
  unit: number,
): void {
  const { width, height } = context.canvas;
  const each = width / columns;
  const [from, to] = ends.map(([x, y]): Point => [(x + column) * each, y * height]);
  const isIn = ends[1]![0] > 0 && ends[1]![0] < 1 && ends[1]![1] > 0 && ends[1]![1] < 1;
  if (!isIn) return;
  context.save();
  context.beginPath();
  context.rect(column * each, 0, each, height);
  context.clip();
  drawLine(context, from!, to!, 2 * unit, markColor, '#ffffff99');
  for (const [[x, y], radius] of [
    [from!, 3],
    [to!, 8],
  ] as const) {
    context.beginPath();
    context.arc(x, y, radius * unit, 0, 2 * Math.PI);
    Object.assign(context, { strokeStyle: markColor, lineWidth: 2 * unit });
    context.stroke();
  }
  setFont(context, textSize * unit);
  const half = context.measureText(text).width / 2 + 7 * unit;
  const side = ends[1]![0] > 0.6 ? -1 : 1;
  drawChip(context, text, to![0] + side * (half + 14 * unit), to![1], unit, each, [
    '#ffffff',
    markColor,
  ]);
  context.restore();
}

function drawLegend(
  context: CanvasRenderingContext2D,
  about: string,
  ticks: readonly string[],
  unit: number,
): void {
  const { width, height } = context.canvas;
  const [boxWidth, boxHeight] = [Math.min(width - 16 * unit, 400 * unit), 62 * unit];
  const [left, top] = [(width - boxWidth) / 2, height - boxHeight - 10 * unit];
  drawBox(context, left, top, boxWidth, boxHeight, paper);
  const [inner, room] = [left + 10 * unit, boxWidth - 20 * unit];
  const swatch = 10 * unit;
  drawBox(context, inner, top + 9 * unit, swatch, swatch, cssColor(zeroColor));
  const gradient = context.createLinearGradient(inner, 0, inner + room, 0);
  errorRamp.forEach((color, i) =>
    gradient.addColorStop(i / (errorRamp.length - 1), cssColor(color)),
  );
  context.fillStyle = gradient;
  context.fillRect(inner, top + 25 * unit, room, 10 * unit);
  context.fillStyle = ink;
  setFont(context, 11 * unit);
  context.textAlign = 'left';
  const text = `none · ${about}`;
  context.fillText(text, inner + swatch + 5 * unit, top + 14 * unit, room - swatch - 5 * unit);
  ticks.forEach((tick, i) => {
    context.textAlign = (['left', 'center', 'right'] as const)[i]!;
    context.fillText(tick, inner + (room * i) / 2, top + 47 * unit, room / 3);
  });
}

function drawBox(
  context: CanvasRenderingContext2D,
  x: number,
  y: number,
  width: number,
  height: number,
  color: string,
): void {
  context.beginPath();
  context.roundRect(x, y, width, height, Math.min(8, height / 3));
  context.fillStyle = color;
  context.fill();
}

function setFont(context: CanvasRenderingContext2D, size: number): void {
  context.font = `${size}px system-ui, sans-serif`;
}
