import type { KeySelection } from '../../core/motion/key-selection.ts';
import { sameTime } from '../../core/motion/edit/keys.ts';
import type { ChannelKey } from '../../core/motion/targets.ts';
import { handlesOf, type SlopeHandle } from './handles.ts';
import { keyPlace, yAtX } from './line-samples.ts';
import type { PlotLine } from './plot-lines.ts';
import type { Place, Plot } from './plot.ts';
import {
  type Box,
  boxAround,
  type BoxHandle,
  boxHandles,
  handlePlace,
  visibleBox,
} from './scale-box.ts';

/** What is under the pointer. */
export type Hit =
  | { readonly of: 'handle'; readonly handle: SlopeHandle }
  | { readonly of: 'box'; readonly box: Box; readonly handle: BoxHandle }
  | { readonly of: 'key'; readonly line: PlotLine; readonly at: number }
  | { readonly of: 'line'; readonly line: PlotLine }
  | { readonly of: 'nothing' };

/** What the plot shows, as far as the pointer can meet it. */
export interface Shown {
  readonly lines: readonly PlotLine[];
  /** Channels that can be seen and not changed. */
  readonly locked: ReadonlySet<ChannelKey>;
  readonly selection: KeySelection;
  readonly plot: Plot;
}

/** How many keys show their handles at most; more would hide the curves. */
const mostWithHandles = 60;

/** A key of a line. */
export interface LineKey {
  readonly line: PlotLine;
  readonly at: number;
}

export function isSelected(selection: KeySelection, { line, at }: LineKey): boolean {
  const time = line.times[at]!;
  return selection.get(line.key)?.some((each) => sameTime(each, time)) ?? false;
}

function selectedKeys({ lines, selection }: Pick<Shown, 'lines' | 'selection'>): LineKey[] {
  return lines.flatMap((line) => {
    const chosen = selection.get(line.key);
    if (!chosen || chosen.length === 0) return [];
    // Both are increasing, so that a thousand keys take a thousand steps.
    const found: LineKey[] = [];
    let next = 0;
    line.times.forEach((time, at) => {
      while (next < chosen.length && !sameTime(chosen[next]!, time) && chosen[next]! < time) next++;
      if (next < chosen.length && sameTime(chosen[next]!, time)) found.push({ line, at });
    });
    return found;
  });
}

/** The handles that are drawn: those of selected keys of curves that can be changed. */
export function shownHandles(shown: Shown): readonly SlopeHandle[] {
  const keys = selectedKeys(shown).filter(({ line }) => !shown.locked.has(line.key));
  if (keys.length > mostWithHandles) return [];
  return keys.flatMap(({ line, at }) => handlesOf(line, at, shown.plot));
}

/** The box by which selected keys are scaled; null with fewer than two. */
export function shownBox(shown: Shown): Box | null {
  const keys = selectedKeys(shown).filter(({ line }) => !shown.locked.has(line.key));
  return boxAround(keys.map(({ line, at }) => keyPlace(line, at, shown.plot)));
}

/**
 * Finds what the pointer meets: the nearest of keys, handles and the corners of the box, in this
 * order where they are equally near, and lines only where there is none of these, so that whatever
 * is small can be pressed.
 *
 * @param reach in pixels, from which a key or handle is met; a finger reaches farther
 */
export function hitAt(shown: Shown, pointer: Place, reach: number): Hit {
  const { lines, locked, plot } = shown;
  const open = lines.filter(({ key }) => !locked.has(key));
  const keys = open.flatMap(keysNear(plot, pointer, reach)).map(({ distance, line, at }) => {
    return { distance, hit: { of: 'key', line, at } as const };
  });
  const handles = shownHandles(shown).map((handle) => {
    return { distance: distanceOf(handle.end, pointer), hit: { of: 'handle', handle } as const };
  });
  const small = nearest<Near>([...keys, ...handles, ...cornersNear(shown, pointer)], reach);
  if (small) return small.hit;
  const line = nearest(
    open.map((each) => ({ line: each, distance: lineDistance(each, plot, pointer) })),
    reach,
  );
  return line ? { of: 'line', line: line.line } : { of: 'nothing' };
}

interface Near {
  readonly distance: number;
  readonly hit: Hit;
}

function cornersNear(shown: Shown, pointer: Place): readonly Near[] {
  const box = shownBox(shown);
  const visible = box && visibleBox(box, shown.plot);
  if (!visible) return [];
  return boxHandles.map((handle) => ({
    distance: distanceOf(handlePlace(visible, handle), pointer),
    hit: { of: 'box', box, handle },
  }));
}

const keysNear =
  (plot: Plot, pointer: Place, reach: number) =>
  (line: PlotLine): (LineKey & { readonly distance: number })[] =>
    Array.from(line.times, (_, at) => {
      return { line, at, distance: distanceOf(keyPlace(line, at, plot), pointer) };
    }).filter(({ distance }) => distance <= reach);

/** The distance of a place from a line: the least to its pieces of a few pixels around. */
function lineDistance(line: PlotLine, plot: Plot, { x, y }: Place): number {
  let least = Infinity;
  for (let column = -4; column < 4; column++) {
    const [left, right] = [x + column, x + column + 1];
    const [from, to] = [yAtX(line, plot, left), yAtX(line, plot, right)];
    const down = Math.min(Math.max(y, Math.min(from, to)), Math.max(from, to));
    const across = Math.max(left - x, 0, x - right);
    least = Math.min(least, Math.hypot(across, down - y));
  }
  return least;
}

function distanceOf(a: Place, b: Place): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}

function nearest<T extends { readonly distance: number }>(
  candidates: readonly T[],
  reach: number,
): T | null {
  let found: T | null = null;
  for (const each of candidates) {
    if (each.distance <= reach && (!found || each.distance < found.distance)) found = each;
  }
  return found;
}

/** The keys of open lines within a rectangle of the plot, as a selection. */
export function keysInBox(
  { lines, locked, plot }: Shown,
  { left, right, top, bottom }: Box,
): KeySelection {
  const found = new Map<ChannelKey, readonly number[]>();
  for (const line of lines) {
    if (locked.has(line.key)) continue;
    const times = [...line.times].filter((_, at) => {
      const { x, y } = keyPlace(line, at, plot);
      return x >= left && x <= right && y >= top && y <= bottom;
    });
    // A rotation is drawn as three lines with the same keys.
    const all = new Set([...(found.get(line.key) ?? []), ...times]);
    if (all.size > 0)
      found.set(
        line.key,
        [...all].sort((a, b) => a - b),
      );
  }
  return found;
}
