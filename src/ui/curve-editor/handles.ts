import { keyPlace } from './line-samples.ts';
import type { PlotLine } from './plot-lines.ts';
import { type Place, type Plot, slopePixels } from './plot.ts';

export type HandleSide = 'in' | 'out';

/** An end of the line through a key that shows its slope on one side. */
export interface SlopeHandle {
  readonly line: PlotLine;
  /** The key's index. */
  readonly at: number;
  readonly side: HandleSide;
  readonly key: Place;
  readonly end: Place;
}

/** How far a handle stands from its key, in pixels. */
const handleLength = 42;
/** A handle is never steeper than a pointer this far from its key, in pixels, makes it. */
const leastAcross = 1;

/** The handles of a key: one on each side on which its slope has an effect. */
export function handlesOf(line: PlotLine, at: number, plot: Plot): readonly SlopeHandle[] {
  const { slopes } = line;
  if (!slopes) return [];
  const key = keyPlace(line, at, plot);
  const handle = (side: HandleSide, slope: number): SlopeHandle => {
    const fall = slope * line.scale.factor * slopePixels(plot);
    const across = ((side === 'in' ? -1 : 1) * handleLength) / Math.hypot(1, fall);
    return { line, at, side, key, end: { x: key.x + across, y: key.y + across * fall } };
  };
  return [
    ...(slopes.actsBefore(at) ? [handle('in', slopes.before[at]!)] : []),
    ...(slopes.actsAfter(at) ? [handle('out', slopes.after[at]!)] : []),
  ];
}

/** The slope, in value a second, that turns a handle toward the pointer; it keeps to its side. */
export function slopeToward({ key, side, line }: SlopeHandle, pointer: Place, plot: Plot): number {
  const toward = side === 'in' ? -1 : 1;
  const across = toward * Math.max(toward * (pointer.x - key.x), leastAcross);
  return (pointer.y - key.y) / across / slopePixels(plot) / line.scale.factor;
}

/** Whether a key's slopes are one, so that a drag of either handle turns both. */
export function isUnified({ slopes }: PlotLine, at: number): boolean {
  if (!slopes?.actsBefore(at) || !slopes.actsAfter(at)) return false;
  const [a, b] = [slopes.before[at]!, slopes.after[at]!];
  return Math.abs(a - b) <= 1e-9 * Math.max(1, Math.abs(a), Math.abs(b));
}
