import { keyGap } from '../../core/motion/edit/keys.ts';
import type { ClipParts } from '../../core/motion/clip-parts.ts';
import { keysWithin } from '../../core/motion/edit/selection.ts';
import type { KeySelection } from '../../core/motion/key-selection.ts';
import { channelKey } from '../../core/motion/targets.ts';
import type { Editor } from '../editor.ts';
import { selectedTimes } from './draw-rows.ts';
import { keysOfRow, nearestKey } from './row-keys.ts';
import type { TimelineRow } from './rows.ts';
import { timeAtX, type TimeWindow } from './time-axis.ts';

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
  /** @param isHeld whether a finger that opens it is still down */
  openMenu(x: number, y: number, isHeld: boolean): void;
  scroll(pixels: number): void;
}

/** A key under the pointer. */
export interface Hit {
  readonly row: TimelineRow;
  /** In seconds. */
  readonly time: number;
}

export function rowAt(
  { rows, rowHeight, ...shown }: ShownRows,
  y: number,
): TimelineRow | undefined {
  return rows[Math.floor((y + shown.scrollTop()) / rowHeight)];
}

export function hitAt(shown: ShownRows, x: number, y: number, pixels: number): Hit | null {
  const row = rowAt(shown, y);
  if (!row) return null;
  const { timeWindow, width } = shown;
  const { times } = keysOfRow(row.channels);
  const seconds = (pixels / width) * (timeWindow[1] - timeWindow[0]);
  const time = times[nearestKey(times, timeAtX(timeWindow, width, x), seconds)];
  return time === undefined ? null : { row, time };
}

/** The keys that a diamond of a row stands for. */
export function keysOf({ clip }: ShownRows, { row, time }: Hit): KeySelection {
  return keysOfDiamond(clip, row, time);
}

export function keysOfDiamond(clip: ClipParts, row: TimelineRow, time: number): KeySelection {
  return keysWithin(clip, channelKeys(row), [time - keyGap, time + keyGap]);
}

export function channelKeys({ channels }: TimelineRow): readonly string[] {
  return channels.flatMap(({ target }) => (target ? channelKey(target) : []));
}

export function isAmong({ row, time }: Hit, selection: KeySelection): boolean {
  return nearestKey(selectedTimes(row, selection), time, keyGap) >= 0;
}
