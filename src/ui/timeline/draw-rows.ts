import { keyGap } from '../../core/motion/edit/keys.ts';
import type { KeySelection } from '../../core/motion/key-selection.ts';
import { channelKey } from '../../core/motion/targets.ts';
import { firstAtOrAfter, keysOfRow, mergeTimes, nearestKey } from './row-keys.ts';
import type { RowId, TimelineRow } from './rows.ts';
import { timeAtX, type TimeWindow, xOfTime } from './time-axis.ts';

/** Colors as CSS writes them. */
export interface KeyColors {
  readonly key: string;
  readonly edge: string;
  readonly chosen: string;
  readonly hold: string;
  readonly line: string;
  readonly row: string;
}

/** What the rows of keys show. */
export interface RowPicture {
  readonly rows: readonly TimelineRow[];
  readonly timeWindow: TimeWindow;
  /** In CSS pixels. */
  readonly width: number;
  readonly height: number;
  readonly rowHeight: number;
  /** How far the rows are scrolled. */
  readonly scrollTop: number;
  readonly selection: KeySelection;
  /** The key that keys walk over. */
  readonly cursor: { readonly row: RowId; readonly time: number } | null;
  /** Whether a row has a value that is unkeyed at a time. */
  readonly unkeyed: { readonly time: number; has(row: TimelineRow): boolean } | null;
  /** Whether a row is one of the selected joints'. */
  readonly isLit: (row: TimelineRow) => boolean;
}

/** Half the diagonal of a diamond, and the distance from which keys are a band, in CSS pixels. */
const [size, bandGap] = [5, 4];
/** Draws the visible part of the rows: bars where nothing moves, and the keys as diamonds. */
export function drawRows(
  context: CanvasRenderingContext2D,
  picture: RowPicture,
  colors: KeyColors,
): void {
  const { rows, width, height, rowHeight, scrollTop, cursor, unkeyed, timeWindow } = picture;
  context.clearRect(0, 0, width, height);
  const first = Math.max(0, Math.floor(scrollTop / rowHeight));
  const end = Math.min(rows.length, Math.ceil((scrollTop + height) / rowHeight));
  for (let at = first; at < end; at++) {
    const row = rows[at]!;
    const top = at * rowHeight - scrollTop;
    const middle = top + rowHeight / 2;
    if (picture.isLit(row)) {
      context.fillStyle = colors.row;
      context.fillRect(0, top, width, rowHeight);
    }
    context.fillStyle = colors.line;
    context.fillRect(0, top + rowHeight - 1, width, 1);
    drawKeys(context, row, middle, picture, colors);
    if (unkeyed?.has(row)) {
      context.strokeStyle = colors.chosen;
      context.lineWidth = 1.5;
      context.beginPath();
      diamond(context, xOfTime(timeWindow, width, unkeyed.time), middle, size + 1);
      context.stroke();
    }
    if (cursor?.row === row.id) {
      context.strokeStyle = colors.edge;
      context.lineWidth = 1.5;
      const x = xOfTime(timeWindow, width, cursor.time);
      context.strokeRect(x - size - 3, middle - size - 3, 2 * size + 6, 2 * size + 6);
    }
  }
}

function drawKeys(
  context: CanvasRenderingContext2D,
  row: TimelineRow,
  middle: number,
  { timeWindow, width, selection }: RowPicture,
  colors: KeyColors,
): void {
  const { times, isHeld } = keysOfRow(row.channels);
  const chosen = selectedTimes(row, selection);
  // One key more on both sides, whose bars may reach into the picture.
  const first = Math.max(0, firstAtOrAfter(times, timeAtX(timeWindow, width, -size)) - 1);
  const end = Math.min(
    times.length,
    firstAtOrAfter(times, timeAtX(timeWindow, width, width + size)) + 1,
  );
  const across = (at: number): number => xOfTime(timeWindow, width, times[at]!);
  context.fillStyle = colors.hold;
  for (let at = first; at < end; at++) {
    if (isHeld[at] === 0 || at + 1 >= times.length) continue;
    context.fillRect(across(at), middle - 2, across(at + 1) - across(at), 4);
  }
  const half = row.kind === 'channel' ? size - 0.5 : size;
  for (const isChosen of [false, true]) {
    context.fillStyle = isChosen ? colors.chosen : colors.key;
    context.strokeStyle = colors.edge;
    context.lineWidth = 1;
    for (const [from, to] of keyRuns(first, end, across, isOfKind(times, chosen, isChosen))) {
      if (to === from) drawDiamond(context, across(from), middle, half);
      else drawBand(context, across(from), across(to), middle, half);
    }
  }
}

/** Whether a key is selected, or is not. */
function isOfKind(times: Float64Array, chosen: Float64Array, isChosen: boolean) {
  return (at: number): boolean =>
    (chosen.length > 0 && nearestKey(chosen, times[at]!, keyGap) >= 0) === isChosen;
}

/** Runs of keys of one kind that are too near to each other to be told apart, first to last. */
function keyRuns(
  first: number,
  end: number,
  across: (at: number) => number,
  isWanted: (at: number) => boolean,
): readonly (readonly [from: number, to: number])[] {
  const runs: [number, number][] = [];
  let last = -Infinity;
  for (let at = first; at < end; at++) {
    if (!isWanted(at)) {
      last = -Infinity;
      continue;
    }
    const x = across(at);
    if (x - last < bandGap) runs.at(-1)![1] = at;
    else runs.push([at, at]);
    last = x;
  }
  return runs;
}

/** Keys in a row that is drawn as one shape, with the ends of a diamond. */
function drawBand(
  context: CanvasRenderingContext2D,
  left: number,
  right: number,
  y: number,
  half: number,
): void {
  context.beginPath();
  context.moveTo(left - half, y);
  context.lineTo(left, y - half);
  context.lineTo(right, y - half);
  context.lineTo(right + half, y);
  context.lineTo(right, y + half);
  context.lineTo(left, y + half);
  context.closePath();
  context.fill();
  context.stroke();
}

function drawDiamond(context: CanvasRenderingContext2D, x: number, y: number, half: number): void {
  context.beginPath();
  diamond(context, x, y, half);
  context.fill();
  context.stroke();
}

function diamond(context: CanvasRenderingContext2D, x: number, y: number, half: number): void {
  context.moveTo(x - half, y);
  context.lineTo(x, y - half);
  context.lineTo(x + half, y);
  context.lineTo(x, y + half);
  context.closePath();
}

/** The times of a row's selected keys, increasing; merged once for a selection and a row. */
export function selectedTimes({ channels }: TimelineRow, selection: KeySelection): Float64Array {
  let ofRows = selected.get(selection);
  if (!ofRows) selected.set(selection, (ofRows = new WeakMap()));
  let times = ofRows.get(channels);
  if (!times) {
    const lists = channels.flatMap(({ target }) => {
      const found = target && selection.get(channelKey(target));
      return found ? Float64Array.from(found) : [];
    });
    ofRows.set(channels, (times = mergeTimes(lists)));
  }
  return times;
}

const selected = new WeakMap<KeySelection, WeakMap<TimelineRow['channels'], Float64Array>>();
