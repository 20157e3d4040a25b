import { EdgeScroll } from './edge-scroll.ts';
import { beginDrag } from './key-drags.ts';
import { type Hit, hitAt, isAmong, keysOf, rowAt, type ShownRows } from './shown-rows.ts';
import { panned } from './time-axis.ts';

/** How near to a key a pointer must be, in CSS pixels, and how far it goes before it drags. */
const reach = { mouse: 7, touch: 22 };
const slop = { mouse: 3, touch: 9 };
const longPress = 500; // milliseconds
/**
 * Lets the keys of rows be selected by clicks and boxes, and moved by drags: copied with Alt. By
 * touch a tap selects, a drag of a selected key moves, a drag elsewhere shows other times and rows,
 * and a long press opens the menu that the right button opens.
 *
 * @returns a function that ends it
 */
export function addKeyPointer(element: HTMLElement, shown: ShownRows): () => void {
  const ending = new AbortController();
  const { signal } = ending;
  let press: AbortController | null = null;
  const placeOf = ({ clientX, clientY }: MouseEvent): readonly [number, number] => {
    const { left, top } = element.getBoundingClientRect();
    return [clientX - left, clientY - top];
  };
  const { session } = shown.editor;

  const onDown = (event: PointerEvent): void => {
    // A second finger zooms, and the first one then selects nothing.
    press?.abort();
    press = null;
    if (event.button !== 0 || !event.isPrimary) return;
    press = new AbortController();
    const kind = event.pointerType === 'touch' ? 'touch' : 'mouse';
    const [x, y] = placeOf(event);
    const hit = hitAt(shown, x, y, reach[kind]);
    const row = hit?.row ?? rowAt(shown, y);
    // The focus is set here, so that keys act on the timeline although the canvas has none.
    event.preventDefault();
    if (row) shown.focus(row, hit?.time ?? null);
    element.setPointerCapture(event.pointerId);
    const isMore = event.shiftKey || event.ctrlKey || event.metaKey;
    const drag = beginDrag(shown, hit, isMore, kind, [x, y]);
    let isDragged = false;
    let last: PointerEvent = event;
    const again = (): void => drag.move(...placeOf(last), last);
    const edges = new EdgeScroll({
      size: () => ({ width: shown.width, height: element.clientHeight }),
      scroll: (across, down) => {
        const { timeWindow, width } = shown;
        const seconds = (across / width) * (timeWindow[1] - timeWindow[0]);
        if (seconds !== 0) session.timeWindow.value = panned(timeWindow, seconds);
        shown.scroll(down);
      },
      again,
    });
    const timer =
      kind === 'touch'
        ? window.setTimeout(() => {
            if (isDragged) return;
            press?.abort();
            selectAtMenu(shown, hit);
            shown.openMenu(event.clientX, event.clientY, true);
          }, longPress)
        : 0;
    const listening = { signal: press.signal };
    press.signal.addEventListener('abort', () => {
      window.clearTimeout(timer);
      edges.end();
      drag.cancel();
    });
    const move = (moved: PointerEvent): void => {
      if (moved.pointerId !== event.pointerId) return;
      const [toX, toY] = placeOf(moved);
      isDragged ||= Math.hypot(toX - x, toY - y) > slop[kind];
      if (!isDragged) return;
      last = moved;
      again();
      if (drag.scrolls) edges.moveTo(toX, toY);
    };
    const finish = (ended: PointerEvent): void => {
      if (ended.pointerId !== event.pointerId) return;
      const own = press;
      press = null;
      if (ended.type === 'pointercancel') {
        own?.abort();
        return;
      }
      if (isDragged) drag.end();
      else drag.click();
      // What has ended is not canceled.
      own?.abort();
    };
    element.addEventListener('pointermove', move, listening);
    element.addEventListener('pointerup', finish, listening);
    element.addEventListener('pointercancel', finish, listening);
    window.addEventListener(
      'keydown',
      (key) => {
        if (key.key !== 'Escape') return;
        key.preventDefault();
        key.stopPropagation();
        press?.abort();
        press = null;
      },
      { ...listening, capture: true },
    );
  };
  element.addEventListener('pointerdown', onDown, { signal });
  // A browser gives a touch to something near that listens to clicks, unless this does so too: the
  // keys at the start of a clip would be hidden behind the names of their rows.
  element.addEventListener('mousedown', () => undefined, { signal });
  element.addEventListener(
    'contextmenu',
    (event) => {
      event.preventDefault();
      // A long press opened it already, and chose what it is for.
      if (event instanceof PointerEvent && event.pointerType === 'touch') return;
      selectAtMenu(shown, hitAt(shown, ...placeOf(event), reach.mouse));
      shown.openMenu(event.clientX, event.clientY, false);
    },
    { signal },
  );
  element.addEventListener(
    'dblclick',
    (event) => {
      if (!hitAt(shown, ...placeOf(event), reach.mouse)) session.timeWindow.value = null;
    },
    { signal },
  );
  return () => {
    press?.abort();
    ending.abort();
  };
}

/** The menu is for what is under the pointer, or for all that is selected if that is part of it. */
function selectAtMenu(shown: ShownRows, hit: Hit | null): void {
  const { selectedKeys } = shown.editor.session;
  if (hit && !isAmong(hit, selectedKeys.value)) selectedKeys.value = keysOf(shown, hit);
}
