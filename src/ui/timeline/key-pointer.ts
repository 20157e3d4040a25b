import type { ClipParts } from '../../core/motion/clip-parts.ts';
import { copyKeys, pasteKeys } from '../../core/motion/edit/copy-keys.ts';
import { moveKeys } from '../../core/motion/edit/move-keys.ts';
import { keysWithin, toggled, united } from '../../core/motion/edit/selection.ts';
import { type KeySelection, noKeys } from '../../core/motion/key-selection.ts';
import { channelKey } from '../../core/motion/targets.ts';
import type { Editor } from '../editor.ts';
import { beginKeyGesture, type KeyGesture } from './key-gesture.ts';
import { selectedTimes } from './draw-rows.ts';
import { keysOfRow, nearestKey } from './row-keys.ts';
import type { TimelineRow } from './rows.ts';
import { snapped } from './shown-time.ts';
import { panned, timeAtX, type TimeWindow } from './time-axis.ts';

/** A rectangle that selects keys: left, top, right, bottom in CSS pixels of the rows' window. */
export type KeyBox = readonly [number, number, number, number];

/** The rows of keys as they are shown; it is read anew at each event. */
export interface ShownRows {
  readonly editor: Editor;
  readonly clip: ClipParts;
  readonly rows: readonly TimelineRow[];
  readonly timeWindow: TimeWindow;
  readonly width: number;
  readonly rowHeight: number;
  /** How far the rows are scrolled, in CSS pixels. */
  scrollTop(): number;
  /** Gives a row the focus, and reads its key at a time. */
  readonly focus: (row: TimelineRow, time: number | null) => void;
  showBox(box: KeyBox | null): void;
  openMenu(x: number, y: number): void;
  scroll(pixels: number): void;
}

/** A key under the pointer. */
interface Hit {
  readonly row: TimelineRow;
  /** In seconds. */
  readonly time: number;
}

/** How near to a key a pointer must be, in CSS pixels, and how far it goes before it drags. */
const reach = { mouse: 7, touch: 18 };
const slop = { mouse: 3, touch: 9 };
const longPress = 500; // milliseconds
/** Two times of one key differ less than this, in seconds. */
const sameKey = 1e-4;

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
    if (event.button !== 0) return;
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
    const timer =
      kind === 'touch'
        ? window.setTimeout(() => {
            if (isDragged) return;
            press?.abort();
            selectAtMenu(shown, hit);
            shown.openMenu(event.clientX, event.clientY);
          }, longPress)
        : 0;
    const listening = { signal: press.signal };
    press.signal.addEventListener('abort', () => {
      window.clearTimeout(timer);
      drag.cancel();
    });
    const move = (moved: PointerEvent): void => {
      if (moved.pointerId !== event.pointerId) return;
      const [toX, toY] = placeOf(moved);
      isDragged ||= Math.hypot(toX - x, toY - y) > slop[kind];
      if (isDragged) drag.move(toX, toY, moved);
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
  element.addEventListener(
    'contextmenu',
    (event) => {
      event.preventDefault();
      // A long press opened it already, and chose what it is for.
      if (event instanceof PointerEvent && event.pointerType === 'touch') return;
      selectAtMenu(shown, hitAt(shown, ...placeOf(event), reach.mouse));
      shown.openMenu(event.clientX, event.clientY);
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

/** What a press may become. */
interface KeyDrag {
  move(x: number, y: number, event: PointerEvent): void;
  /** Ends a drag, or a press without one. */
  end(): void;
  click(): void;
  /** Without effect after the end. */
  cancel(): void;
}

function beginDrag(
  shown: ShownRows,
  hit: Hit | null,
  isMore: boolean,
  kind: 'mouse' | 'touch',
  from: readonly [number, number],
): KeyDrag {
  const { selectedKeys } = shown.editor.session;
  const keys = hit ? keysOf(shown, hit) : noKeys;
  const isSelected = hit !== null && isAmong(hit, selectedKeys.value);
  if (kind === 'touch' && !isSelected) {
    return panDrag(shown, from, () => (selectedKeys.value = keys));
  }
  if (!hit) return boxDrag(shown, isMore, from);
  const before = selectedKeys.value;
  if (!isSelected) selectedKeys.value = isMore ? united(before, keys) : keys;
  return moveDrag(shown, hit, from, () => {
    if (isMore) selectedKeys.value = toggled(before, keys);
    else selectedKeys.value = keys;
  });
}

/** Moves the selected keys; with Alt, copies of them. */
function moveDrag(
  shown: ShownRows,
  hit: Hit,
  [fromX]: readonly [number, number],
  click: () => void,
): KeyDrag {
  const { editor } = shown;
  let gesture: KeyGesture | null = null;
  return {
    move: (x, _, { altKey }) => {
      gesture ??= beginKeyGesture(editor, altKey ? 'Copy keys' : 'Move keys');
      const [start, end] = shown.timeWindow;
      const to = hit.time + ((x - fromX) / shown.width) * (end - start);
      const seconds = snapped(editor.session, shown.clip, to) - hit.time;
      gesture?.preview((clip, selection) => {
        if (!altKey) return moveKeys(clip, selection, { seconds });
        const copied = copyKeys(clip, selection);
        return pasteKeys(clip, copied, copied.start + seconds);
      });
    },
    end: () => gesture?.commit(),
    click,
    cancel: () => gesture?.isOpen && gesture.cancel(),
  };
}

/** Selects the keys in a rectangle; with Shift, beside those that are selected. */
function boxDrag(
  shown: ShownRows,
  isMore: boolean,
  [fromX, fromY]: readonly [number, number],
): KeyDrag {
  const { selectedKeys } = shown.editor.session;
  const before = selectedKeys.value;
  const fromTime = timeAtX(shown.timeWindow, shown.width, fromX);
  const fromDown = fromY + shown.scrollTop();
  let isOpen = true;
  return {
    move: (x, y) => {
      const scrollTop = shown.scrollTop();
      const down = y + scrollTop;
      const [top, bottom] = [Math.min(fromDown, down), Math.max(fromDown, down)];
      shown.showBox([Math.min(fromX, x), top - scrollTop, Math.max(fromX, x), bottom - scrollTop]);
      const { rows, rowHeight, timeWindow, width, clip } = shown;
      // A row is in the box if its middle is.
      const inside = rows.filter((_, at) => {
        const middle = (at + 0.5) * rowHeight;
        return middle >= top && middle <= bottom;
      });
      const channels = inside.flatMap((row) => channelKeys(row));
      const found = keysWithin(clip, channels, [fromTime, timeAtX(timeWindow, width, x)]);
      selectedKeys.value = isMore ? united(before, found) : found;
    },
    end: () => {
      isOpen = false;
      shown.showBox(null);
    },
    click: () => {
      isOpen = false;
      if (!isMore) selectedKeys.value = noKeys;
    },
    cancel: () => {
      if (!isOpen) return;
      isOpen = false;
      shown.showBox(null);
      selectedKeys.value = before;
    },
  };
}

/** Shows other times and rows, as a finger draws them along. */
function panDrag(
  shown: ShownRows,
  [fromX, fromY]: readonly [number, number],
  click: () => void,
): KeyDrag {
  let [lastX, lastY] = [fromX, fromY];
  return {
    move: (x, y) => {
      const { timeWindow, width, editor } = shown;
      const seconds = ((lastX - x) / width) * (timeWindow[1] - timeWindow[0]);
      editor.session.timeWindow.value = panned(timeWindow, seconds);
      shown.scroll(lastY - y);
      [lastX, lastY] = [x, y];
    },
    end: () => undefined,
    click,
    cancel: () => undefined,
  };
}

/** The menu is for what is under the pointer, or for all that is selected if that is part of it. */
function selectAtMenu(shown: ShownRows, hit: Hit | null): void {
  const { selectedKeys } = shown.editor.session;
  if (hit && !isAmong(hit, selectedKeys.value)) selectedKeys.value = keysOf(shown, hit);
}

function rowAt({ rows, rowHeight, ...shown }: ShownRows, y: number): TimelineRow | undefined {
  return rows[Math.floor((y + shown.scrollTop()) / rowHeight)];
}

function hitAt(shown: ShownRows, x: number, y: number, pixels: number): Hit | null {
  const row = rowAt(shown, y);
  if (!row) return null;
  const { timeWindow, width } = shown;
  const { times } = keysOfRow(row.channels);
  const seconds = (pixels / width) * (timeWindow[1] - timeWindow[0]);
  const time = times[nearestKey(times, timeAtX(timeWindow, width, x), seconds)];
  return time === undefined ? null : { row, time };
}

/** The keys that a diamond of a row stands for. */
function keysOf({ clip }: ShownRows, { row, time }: Hit): KeySelection {
  return keysOfDiamond(clip, row, time);
}

export function keysOfDiamond(clip: ClipParts, row: TimelineRow, time: number): KeySelection {
  return keysWithin(clip, channelKeys(row), [time - sameKey, time + sameKey]);
}

function channelKeys({ channels }: TimelineRow): readonly string[] {
  return channels.flatMap(({ target }) => (target ? channelKey(target) : []));
}

function isAmong({ row, time }: Hit, selection: KeySelection): boolean {
  return nearestKey(selectedTimes(row, selection), time, sameKey) >= 0;
}
