import { errorRamp, zeroColor } from '../../skinning/weights/ramps.ts';
import { cssColor } from '../css-color.ts';
import { textIsLeft } from './place-of-worst.ts';

type Point = readonly [x: number, y: number];

const [ink, paper, markColor] = ['#1b1f24', '#ffffffe0', '#b3126a'];
/** The size of text, in units. */
const textSize = 13;
/** Text that would be wider than its room gets no smaller than this part of that. */
const smallest = 0.6;
/** In a view that is narrower, in units, the figure of a mark stands below it. */
const narrow = 280;

/** A vertex at two places, as parts of a view's width and height, and how far apart they are, or null. */
export interface PictureMark {
  readonly text: string | null;
  readonly from: Point;
  readonly to: Point;
}

/** The line between two views. */
export function drawDivider(context: CanvasRenderingContext2D, x: number, unit: number): void {
  const { height } = context.canvas;
  for (const [width, color] of [
    [4, '#00000066'],
    [2, '#ffffff'],
  ] as const) {
    context.fillStyle = color;
    context.fillRect(x - (width / 2) * unit, 0, width * unit, height);
  }
}

/** A name at the top of a view between two places of the picture, if there is room. */
export function drawName(
  context: CanvasRenderingContext2D,
  name: string,
  [from, to]: Point,
  unit: number,
): void {
  const room = to - from - 8 * unit;
  if (room > 20 * unit) drawChip(context, name, [(from + to) / 2, 23 * unit], unit, room);
}

/** Text in a box around a place, in smaller letters where it would be wider than its room. */
function drawChip(
  context: CanvasRenderingContext2D,
  text: string,
  [x, y]: Point,
  unit: number,
  room: number,
  { color = ink, back = paper } = {},
): void {
  const padding = 7 * unit;
  setFont(context, textSize * unit);
  const part = Math.min(1, (room - 2 * padding) / context.measureText(text).width);
  const size = textSize * unit * Math.max(smallest, part);
  setFont(context, size);
  const width = context.measureText(text).width + 2 * padding;
  drawBox(context, x - width / 2, y - 0.85 * size, width, 1.7 * size, back);
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.fillStyle = color;
  context.fillText(text, x, y);
}

/** The mark of the largest difference in one of the views that are side by side. */
export function drawMark(
  context: CanvasRenderingContext2D,
  { text, ...ends }: PictureMark,
  column: number,
  columns: number,
  unit: number,
): void {
  if (ends.to.some((part) => part < 0 || part > 1)) return;
  const { width, height } = context.canvas;
  const each = width / columns;
  const [from, to] = [ends.from, ends.to].map(([x, y]): Point => [(x + column) * each, y * height]);
  context.save();
  context.beginPath();
  context.rect(column * each, 0, each, height);
  context.clip();
  Object.assign(context, { strokeStyle: markColor, fillStyle: markColor, lineWidth: 2 * unit });
  context.beginPath();
  context.moveTo(...from!);
  context.lineTo(...to!);
  context.stroke();
  context.beginPath();
  context.arc(...from!, 3 * unit, 0, 2 * Math.PI);
  context.fill();
  context.beginPath();
  context.arc(...to!, 8 * unit, 0, 2 * Math.PI);
  context.stroke();
  if (text !== null) drawMarkText(context, text, { to: to!, part: ends.to[0], each, column }, unit);
  context.restore();
}

/** The figure of a mark beside it, or below it where that is too wide. */
function drawMarkText(
  context: CanvasRenderingContext2D,
  text: string,
  at: { readonly to: Point; readonly part: number; readonly each: number; readonly column: number },
  unit: number,
): void {
  const { to, part, each, column } = at;
  setFont(context, textSize * unit);
  const half = context.measureText(text).width / 2 + 7 * unit;
  const beside = to[0] + (textIsLeft(part) ? -1 : 1) * (half + 14 * unit);
  const within = Math.min((column + 1) * each - half, Math.max(column * each + half, to[0]));
  const place: Point = each < narrow * unit ? [within, to[1] + 24 * unit] : [beside, to[1]];
  drawChip(context, text, place, unit, each, { color: '#ffffff', back: markColor });
}

/**
 * What the colors of a heat map mean, at the foot of the picture.
 *
 * @param ticks of the scale's beginning, middle and end
 */
export function drawLegend(
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
  context.textBaseline = 'middle';
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
