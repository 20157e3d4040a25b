import { panned, zoomed } from '../../../timeline/time-axis.ts';
import {
  type Place,
  type Plot,
  plottedAt,
  timeAt,
  zoomedValues,
} from '../../../curve-editor/plot.ts';
import type { PlotView } from './plot-view.ts';

/** How much a turn of the wheel by one pixel zooms. */
const zoomByPixel = 0.0015;

/** Lets the wheel, the middle button and two fingers move and zoom what the plot shows. */
export function listenToWindow(view: PlotView): void {
  const { canvas } = view;
  const placeOf = ({ clientX, clientY }: MouseEvent): Place => {
    const { left, top } = canvas.getBoundingClientRect();
    return { x: clientX - left, y: clientY - top };
  };
  const fingers = new Map<number, Place>();

  const onWheel = (event: WheelEvent): void => {
    event.preventDefault();
    const { plot } = view.shown();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
    const [across, down] = [event.deltaX * lines, event.deltaY * lines];
    if (event.shiftKey) {
      pan(view, plot, { x: -(across || down), y: 0 });
      return;
    }
    const factor = Math.exp(down * zoomByPixel);
    const isOfValue = event.ctrlKey || event.altKey || event.metaKey;
    zoom(view, plot, placeOf(event), isOfValue ? [1, factor] : [factor, 1]);
    if (!isOfValue && across !== 0) pan(view, view.shown().plot, { x: -across, y: 0 });
  };

  const onDown = (event: PointerEvent): void => {
    const isMiddle = event.button === 1 && event.pointerType === 'mouse';
    if (!isMiddle && event.pointerType !== 'touch') return;
    if (isMiddle) event.preventDefault();
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, placeOf(event));
  };
  const onMove = (event: PointerEvent): void => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    const now = placeOf(event);
    const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1];
    const isTouch = event.pointerType === 'touch';
    fingers.set(event.pointerId, now);
    if (isTouch && !other) return;
    const { plot } = view.shown();
    if (!other) {
      pan(view, plot, { x: now.x - before.x, y: now.y - before.y });
      return;
    }
    // The middle of two fingers goes half as far as the one that moves.
    pan(view, plot, { x: (now.x - before.x) / 2, y: (now.y - before.y) / 2 });
    const middle = { x: (now.x + other.x) / 2, y: (now.y + other.y) / 2 };
    zoom(view, view.shown().plot, middle, [
      apart(before.x - other.x, now.x - other.x),
      apart(before.y - other.y, now.y - other.y),
    ]);
  };
  const onUp = ({ pointerId }: PointerEvent): void => void fingers.delete(pointerId);
  canvas.addEventListener('wheel', onWheel, { passive: false });
  canvas.addEventListener('pointerdown', onDown);
  canvas.addEventListener('pointermove', onMove);
  canvas.addEventListener('pointerup', onUp);
  canvas.addEventListener('pointercancel', onUp);
}

/** Fingers nearer to each other than this in one direction do not zoom in it, in pixels. */
const leastApart = 40;

function apart(before: number, now: number): number {
  const isApart = Math.min(Math.abs(before), Math.abs(now)) >= leastApart;
  return isApart ? Math.abs(before / now) : 1;
}

/**
 * Moves what the plot shows.
 *
 * @param by pixels to the right and downward
 */
export function pan({ model, editor }: PlotView, plot: Plot, by: Place): void {
  const seconds = timeAt(plot, 0) - timeAt(plot, by.x);
  const plotted = plottedAt(plot, 0) - plottedAt(plot, by.y);
  editor.session.timeWindow.value = panned(plot.time, seconds);
  if (by.y !== 0) model.values.value = [plot.values[0] + plotted, plot.values[1] + plotted];
}

function zoom(
  { model, editor }: PlotView,
  plot: Plot,
  about: Place,
  [time, value]: readonly [number, number],
): void {
  if (time !== 1) {
    editor.session.timeWindow.value = zoomed(plot.time, timeAt(plot, about.x), time);
  }
  if (value !== 1) {
    model.values.value = zoomedValues(plot.values, plottedAt(plot, about.y), value);
  }
}
