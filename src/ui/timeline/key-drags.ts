import { copyKeys, pasteKeys } from '../../core/motion/edit/copy-keys.ts';
import { moveKeys } from '../../core/motion/edit/move-keys.ts';
import { keysWithin, toggled, united } from '../../core/motion/edit/selection.ts';
import { noKeys } from '../../core/motion/key-selection.ts';
import { beginKeyGesture, type KeyGesture } from './key-gesture.ts';
import { channelKeys, type Hit, isAmong, keysOf, type ShownRows } from './shown-rows.ts';
import { snapped } from './shown-time.ts';
import { panned, timeAtX, xOfTime } from './time-axis.ts';

/** What a press may become. */
interface KeyDrag {
  /** Whether it goes on beyond the edges of the view, which then shows what lies there. */
  readonly scrolls: boolean;
  move(x: number, y: number, event: PointerEvent): void;
  /** Ends a drag, or a press without one. */
  end(): void;
  click(): void;
  /** Without effect after the end. */
  cancel(): void;
}

/** Returns what a press on a key, or beside all keys, becomes. */
export function beginDrag(
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
  const fromTime = timeAtX(shown.timeWindow, shown.width, fromX);
  let gesture: KeyGesture | null = null;
  return {
    scrolls: true,
    move: (x, _, { altKey }) => {
      gesture ??= beginKeyGesture(editor, altKey ? 'Copy keys' : 'Move keys');
      const to = hit.time + timeAtX(shown.timeWindow, shown.width, x) - fromTime;
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
    scrolls: true,
    move: (x, y) => {
      const scrollTop = shown.scrollTop();
      const down = y + scrollTop;
      const [top, bottom] = [Math.min(fromDown, down), Math.max(fromDown, down)];
      const { rows, rowHeight, timeWindow, width, clip } = shown;
      const startX = xOfTime(timeWindow, width, fromTime);
      const [left, right] = [Math.min(startX, x), Math.max(startX, x)];
      shown.showBox([left, top - scrollTop, right, bottom - scrollTop]);
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
    scrolls: false,
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
