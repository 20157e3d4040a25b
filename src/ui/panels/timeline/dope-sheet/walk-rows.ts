import { toggled } from '../../../../core/motion/edit/selection.ts';
import { keysOfDiamond, type ShownRows } from '../../../timeline/shown-rows.ts';
import { keyText } from '../../../timeline/key-text.ts';
import { firstAtOrAfter, keysOfRow, nearestKey } from '../../../timeline/row-keys.ts';
import type { RowId, TimelineRow } from '../../../timeline/rows.ts';
import { panned } from '../../../timeline/time-axis.ts';
import { timeUnit } from '../../../timeline/timeline-state.ts';

/** What a key press in a row acts on. */
interface RowWalk extends Pick<ShownRows, 'editor' | 'clip' | 'rows' | 'timeWindow' | 'focus'> {
  /** The row that has the focus. */
  readonly row: TimelineRow;
  readonly cursor: { readonly row: RowId; readonly time: number } | null;
  readonly fold: (row: TimelineRow, part: 'branch' | 'channels') => void;
  /** Selects the joint of a row. */
  readonly select: (row: TimelineRow, isMore: boolean) => void;
  /** Says a text to screen readers. */
  readonly say: (text: string) => void;
}

/**
 * Acts on a key in the list of rows: ↑ ↓ go to other rows, ← → read key after key, Enter and Space
 * select the key, or the joint as long as no key was read; with Shift, ← → fold and unfold.
 */
export function walkRows(walk: RowWalk, event: KeyboardEvent): void {
  const { rows, row, focus, fold } = walk;
  const { key, shiftKey } = event;
  if (event.altKey || event.ctrlKey || event.metaKey) return;
  const at = rows.findIndex(({ id }) => id === row.id);
  const goTo = (index: number): void => {
    const next = rows[index];
    if (next) focus(next, null);
  };
  const unfold = (): void => {
    if (row.showsBranch === false) fold(row, 'branch');
    else if (row.showsChannels === false) fold(row, 'channels');
    else goTo(at + 1);
  };
  const close = (): void => {
    if (row.showsChannels === true) fold(row, 'channels');
    else if (row.showsBranch === true) fold(row, 'branch');
    else goTo(rows.findLastIndex((each, i) => i < at && each.level < row.level));
  };
  const actions: Readonly<Record<string, () => void>> = {
    ArrowDown: () => goTo(at + 1),
    ArrowUp: () => goTo(at - 1),
    PageDown: () => goTo(Math.min(rows.length - 1, at + 10)),
    PageUp: () => goTo(Math.max(0, at - 10)),
    ArrowRight: () => (shiftKey ? unfold() : readKey(walk, 1)),
    ArrowLeft: () => (shiftKey ? close() : readKey(walk, -1)),
    Enter: () => choose(walk, shiftKey),
    ' ': () => choose(walk, true),
  };
  const action = actions[key];
  if (action) {
    event.preventDefault();
    action();
  } else if (key === 'Home' || key === 'End') {
    // The command that follows goes there with the playhead, and reading goes on from it.
    focus(row, null);
  } else if (key === 'Delete' || key === 'Backspace') {
    // The command that follows removes what is selected: by keys that is, at least, what was read.
    const time = timeAtCursor(walk);
    const { selectedKeys } = walk.editor.session;
    if (time !== null && selectedKeys.value.size === 0)
      selectedKeys.value = keysOfDiamond(walk.clip, row, time);
  }
}

/** The time of the key that was read last in this row, if it is still there. */
function timeAtCursor({ row, cursor }: RowWalk): number | null {
  if (cursor?.row !== row.id) return null;
  const { times } = keysOfRow(row.channels);
  return times[nearestKey(times, cursor.time, 1e-4)] ?? null;
}

/** Goes to the next key of the row, from the last one that was read or from the playhead. */
function readKey(walk: RowWalk, direction: 1 | -1): void {
  const { editor, clip, row, cursor, focus, say, timeWindow } = walk;
  const { times } = keysOfRow(row.channels);
  if (times.length === 0) {
    say(`${row.fullName} has no keys`);
    return;
  }
  const isGoingOn = cursor?.row === row.id;
  const from = isGoingOn ? cursor.time : editor.session.clipTime.value;
  const gap = isGoingOn ? 1e-4 : -1e-4;
  const next =
    direction > 0 ? firstAtOrAfter(times, from + gap) : firstAtOrAfter(times, from - gap) - 1;
  const index = Math.min(Math.max(next, 0), times.length - 1);
  const time = times[index]!;
  const [start, end] = timeWindow;
  if (time < start || time > end)
    editor.session.timeWindow.value = panned(timeWindow, time - (start + end) / 2);
  focus(row, time);
  say(keyText(row, index, clip.fps, timeUnit.value));
}

/** Selects the key that was read, alone or beside the others, or else the joint of the row. */
function choose(walk: RowWalk, isMore: boolean): void {
  const { editor, clip, row, say } = walk;
  const { selectedKeys } = editor.session;
  const time = timeAtCursor(walk);
  if (time === null) {
    walk.select(row, false);
    return;
  }
  const keys = keysOfDiamond(clip, row, time);
  const before = selectedKeys.value.size;
  selectedKeys.value = isMore ? toggled(selectedKeys.value, keys) : keys;
  say(selectedKeys.value.size < before ? 'Not selected' : 'Selected');
}
