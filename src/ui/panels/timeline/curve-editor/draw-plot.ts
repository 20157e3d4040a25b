import { keyGap } from '../../../../core/motion/edit/keys.ts';
import { type Shown, shownBox, shownHandles } from '../../../curve-editor/hits.ts';
import { keyPlace, sampleLine } from '../../../curve-editor/line-samples.ts';
import type { PlotLine } from '../../../curve-editor/plot-lines.ts';
import { type Place, type Plot, timeAt, xOf, yOf } from '../../../curve-editor/plot.ts';
import { type Box, boxHandles, handlePlace, visibleBox } from '../../../curve-editor/scale-box.ts';
import { type ValueUnit, valueMarks } from '../../../curve-editor/value-axis.ts';
import { rulerMarks } from '../../../timeline/marks.ts';
import { firstAtOrAfter, nearestKey } from '../../../timeline/row-keys.ts';
import type { TimeUnit } from '../../../timeline/timeline-state.ts';
import type { PlotColors } from './plot-colors.ts';

/** What is drawn. */
export interface Picture extends Shown {
  readonly colors: PlotColors;
  readonly fps: number;
  /** What the ruler above is marked in. */
  readonly timeUnit: TimeUnit;
  /** The range that is played, in seconds. */
  readonly range: readonly [start: number, end: number];
  /** What the values at the left are measured in, and those at the right, if any. */
  readonly units: readonly [left: ValueUnit, right: ValueUnit | null];
  /** The rectangle by which keys are being selected, or null. */
  readonly chosenBox: Box | null;
}

type Context = CanvasRenderingContext2D;

/** Draws the plot in CSS pixels. */
export function drawPlot(context: Context, picture: Picture): void {
  const { plot, lines } = picture;
  context.clearRect(0, 0, plot.width, plot.height);
  drawGrid(context, picture);
  for (const line of lines) drawLine(context, line, picture);
  drawHandles(context, picture);
  for (const [line, keys] of seenKeys(picture)) drawKeys(context, line, keys, picture);
  const box = shownBox(picture);
  if (box) drawScaleBox(context, box, picture);
  if (picture.chosenBox) drawChosenBox(context, picture.chosenBox, picture.colors);
  drawValues(context, picture);
}

function drawGrid(context: Context, { plot, colors, fps, timeUnit, range, units }: Picture): void {
  const [start, end] = range.map((time) => xOf(plot, time)) as [number, number];
  context.fillStyle = colors.of('beyond');
  context.fillRect(0, 0, Math.max(0, start), plot.height);
  context.fillRect(Math.max(0, end), 0, plot.width, plot.height);
  context.lineWidth = 1;
  context.strokeStyle = colors.of('line');
  context.beginPath();
  for (const mark of rulerMarks(plot.time, plot.width, fps, timeUnit)) {
    if (!mark.text) continue;
    const x = Math.floor(mark.x) + 0.5;
    context.moveTo(x, 0);
    context.lineTo(x, plot.height);
  }
  for (const { plotted } of valueMarks(plot, units[0])) across(context, plot, plotted);
  context.stroke();
  context.strokeStyle = colors.of('strong-line');
  context.beginPath();
  across(context, plot, 0);
  context.stroke();
}

function across(context: Context, plot: Plot, plotted: number): void {
  const y = Math.round(yOf(plot, plotted)) + 0.5;
  context.moveTo(0, y);
  context.lineTo(plot.width, y);
}

function drawValues(context: Context, { plot, colors, units }: Picture): void {
  context.font = '11px system-ui, sans-serif';
  context.textBaseline = 'middle';
  context.lineWidth = 3;
  context.strokeStyle = colors.of('surface');
  context.fillStyle = colors.of('quiet');
  units.forEach((unit, side) => {
    if (!unit) return;
    context.textAlign = side === 0 ? 'left' : 'right';
    const x = side === 0 ? 4 : plot.width - 4;
    for (const { plotted, text } of valueMarks(plot, unit)) {
      const y = yOf(plot, plotted);
      if (y < 8 || y > plot.height - 8) continue;
      context.strokeText(text, x, y);
      context.fillText(text, x, y);
    }
  });
}

function drawLine(context: Context, line: PlotLine, { plot, colors, locked }: Picture): void {
  context.strokeStyle = colors.of(line.color);
  context.lineJoin = 'round';
  context.globalAlpha = locked.has(line.key) ? 0.45 : 1;
  for (const { isBeyond, points } of sampleLine(line, plot)) {
    context.lineWidth = isBeyond ? 1 : 1.75;
    context.setLineDash(isBeyond ? [6, 5] : line.isDotted ? [2, 2] : []);
    context.beginPath();
    for (const { x, y } of points) context.lineTo(x, clamped(y, plot));
    context.stroke();
  }
  context.setLineDash([]);
  context.globalAlpha = 1;
}

/** Coordinates far outside of a canvas are drawn in wrong places. */
function clamped(y: number, { height }: Plot): number {
  return Math.min(Math.max(y, -height * 20), height * 20);
}

function drawHandles(context: Context, picture: Picture): void {
  context.strokeStyle = context.fillStyle = picture.colors.of('text');
  context.lineWidth = 1;
  for (const { key, end } of shownHandles(picture)) {
    context.beginPath();
    context.moveTo(key.x, key.y);
    context.lineTo(end.x, end.y);
    context.stroke();
    context.beginPath();
    context.arc(end.x, end.y, 3.5, 0, 2 * Math.PI);
    context.fill();
  }
}

/** Half of a key's side, in pixels. */
const halfKey = 3.5;
/** More keys than these would hide the curves; only selected ones are drawn then. */
const mostKeys = 4000;

/** The keys of each line that are drawn: those in sight, or if they are too many the selected. */
function seenKeys({ lines, plot, selection }: Picture): ReadonlyMap<PlotLine, SeenKeys> {
  const [start, end] = [timeAt(plot, -halfKey), timeAt(plot, plot.width + halfKey)];
  const seen = lines.map((line): readonly [PlotLine, SeenKeys] => {
    const [from, to] = [firstAtOrAfter(line.times, start), firstAtOrAfter(line.times, end)];
    const chosen = Float64Array.from(selection.get(line.key) ?? []);
    return [line, { at: range(from, to), chosen }];
  });
  if (countOf(seen) <= mostKeys) return new Map(seen);
  const selected = seen.map(([line, { at, chosen }]) => {
    const isChosen = (index: number) => nearestKey(chosen, line.times[index]!, keyGap) >= 0;
    return [line, { at: chosen.length === 0 ? [] : at.filter(isChosen), chosen }] as const;
  });
  return new Map(countOf(selected) <= mostKeys ? selected : []);
}

interface SeenKeys {
  /** Their indices. */
  readonly at: readonly number[];
  /** The times of the line's selected keys, increasing. */
  readonly chosen: Float64Array;
}

function countOf(seen: readonly (readonly [PlotLine, SeenKeys])[]): number {
  return seen.reduce((sum, [, { at }]) => sum + at.length, 0);
}

function range(from: number, end: number): number[] {
  return Array.from({ length: end - from }, (_, i) => from + i);
}

function drawKeys(context: Context, line: PlotLine, keys: SeenKeys, picture: Picture): void {
  const { plot, colors, locked } = picture;
  const [own, surface] = [colors.of(line.color), colors.of('surface')];
  const [accent, text] = [colors.of('accent'), colors.of('text')];
  let former: Place | null = null;
  context.lineWidth = 1.25;
  context.globalAlpha = locked.has(line.key) ? 0.45 : 1;
  for (const at of keys.at) {
    const place = keyPlace(line, at, plot);
    const isMarked = nearestKey(keys.chosen, line.times[at]!, keyGap) >= 0;
    // Of keys on the same spot, as of a curve from afar, one is drawn.
    if (!isMarked && former && Math.hypot(place.x - former.x, place.y - former.y) < 1) continue;
    former = place;
    context.fillStyle = isMarked ? accent : surface;
    context.strokeStyle = isMarked ? text : own;
    const half = isMarked ? halfKey + 1 : halfKey;
    context.fillRect(place.x - half, place.y - half, 2 * half, 2 * half);
    context.strokeRect(place.x - half, place.y - half, 2 * half, 2 * half);
  }
  context.globalAlpha = 1;
}

function drawScaleBox(context: Context, box: Box, { plot, colors }: Picture): void {
  const handles = visibleBox(box, plot);
  if (!handles) return;
  context.strokeStyle = colors.of('quiet');
  context.fillStyle = colors.of('surface');
  context.lineWidth = 1;
  context.strokeRect(box.left, box.top, box.right - box.left, box.bottom - box.top);
  for (const handle of boxHandles) {
    const { x, y } = handlePlace(handles, handle);
    context.beginPath();
    context.rect(x - 3, y - 3, 6, 6);
    context.fill();
    context.stroke();
  }
}

function drawChosenBox(context: Context, box: Box, colors: PlotColors): void {
  const size = [box.right - box.left, box.bottom - box.top] as const;
  context.fillStyle = context.strokeStyle = colors.of('accent');
  context.globalAlpha = 0.14;
  context.fillRect(box.left, box.top, ...size);
  context.globalAlpha = 1;
  context.strokeRect(box.left, box.top, ...size);
}
