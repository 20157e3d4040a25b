import { panned, timeAtX, type TimeWindow, zoomed } from './time-axis.ts';

/** What gestures on a view of the timeline change. It is read anew at each event. */
export interface ShownAxes {
  readonly width: number;
  readonly timeWindow: TimeWindow;
  showTime(window: TimeWindow): void;
  /** Moves what the view shows from top to bottom, if that can move: rows, or values. */
  panAcross?(pixels: number): void;
  /** Shows more values if the factor exceeds 1; the place y (CSS pixels from the top) stays. */
  zoomAcross?(y: number, factor: number): void;
}

/** How much one notch of a wheel (100 pixels) zooms. */
const zoomPerPixel = Math.log(1.2) / 100;

/**
 * Lets a view of the timeline be zoomed about the cursor by the wheel (Shift or a horizontal wheel
 * pans, Alt scrolls), panned by a middle drag, and both by two fingers. Its element lies as the
 * ruler does.
 *
 * @returns a function that ends it
 */
export function addAxisGestures(element: HTMLElement, axes: ShownAxes): () => void {
  const ending = new AbortController();
  const { signal } = ending;
  /** Where fingers, or the middle button, are down. */
  const fingers = new Map<number, PointerEvent>();
  const placeOf = ({ clientX, clientY }: MouseEvent): readonly [number, number] => {
    const { left, top } = element.getBoundingClientRect();
    return [clientX - left, clientY - top];
  };
  const pan = (pixels: number, across: number): void => {
    const { timeWindow: shown, width } = axes;
    axes.showTime(panned(shown, (-pixels / width) * (shown[1] - shown[0])));
    axes.panAcross?.(across);
  };
  const zoom = (x: number, y: number, factor: number): void => {
    const { timeWindow: shown, width } = axes;
    axes.showTime(zoomed(shown, timeAtX(shown, width, x), factor));
    axes.zoomAcross?.(y, factor);
  };

  element.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      const { deltaX, deltaY, shiftKey, altKey } = event;
      // A line or a page of a wheel that counts in these is 16 pixels or more.
      const unit = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? 1 : 33;
      if (altKey) axes.panAcross?.(-deltaY * unit);
      else if (shiftKey) pan(-(deltaX || deltaY) * unit, 0);
      else if (Math.abs(deltaX) > Math.abs(deltaY)) pan(-deltaX * unit, 0);
      else zoom(...placeOf(event), Math.exp(deltaY * unit * zoomPerPixel));
    },
    { passive: false, signal },
  );
  element.addEventListener(
    'pointerdown',
    (event) => {
      const isMiddle = event.pointerType === 'mouse' && event.button === 1;
      if (!isMiddle && event.pointerType !== 'touch') return;
      fingers.set(event.pointerId, event);
      // A browser scrolls by a press of the middle button.
      if (isMiddle) event.preventDefault();
      if (isMiddle || fingers.size === 2) element.setPointerCapture(event.pointerId);
    },
    { signal },
  );
  element.addEventListener(
    'pointermove',
    (event) => {
      const before = fingers.get(event.pointerId);
      if (!before) return;
      fingers.set(event.pointerId, event);
      const [x, y] = placeOf(event);
      const [oldX, oldY] = placeOf(before);
      if (event.pointerType === 'mouse') pan(x - oldX, y - oldY);
      const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1];
      if (!other) return;
      const [otherX, otherY] = placeOf(other);
      pan((x - oldX) / 2, (y - oldY) / 2);
      const spread = Math.hypot(x - otherX, y - otherY);
      const oldSpread = Math.hypot(oldX - otherX, oldY - otherY);
      if (spread > 8 && oldSpread > 8) zoom((x + otherX) / 2, (y + otherY) / 2, oldSpread / spread);
    },
    { signal },
  );
  for (const type of ['pointerup', 'pointercancel'] as const)
    element.addEventListener(type, ({ pointerId }) => fingers.delete(pointerId), { signal });
  return () => ending.abort();
}
