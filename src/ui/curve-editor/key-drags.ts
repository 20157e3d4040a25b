import type { ClipParts } from '../../core/motion/clip-parts.ts';
import type { EditedKeys } from '../../core/motion/edit/selection.ts';
import { setTangents } from '../../core/motion/edit/tangents.ts';
import type { KeySelection } from '../../core/motion/key-selection.ts';
import { atFrame } from '../timeline/time-axis.ts';
import { moveInPlot, oneKey, type Scales, scaleInPlot } from './curve-edits.ts';
import { keyCount, movedText, slopeText } from './drag-texts.ts';
import { isUnified, type SlopeHandle, slopeToward } from './handles.ts';
import type { LineKey } from './hits.ts';
import { type Place, type Plot, plottedAt, timeAt } from './plot.ts';
import { type Box, type BoxHandle, scalingOf } from './scale-box.ts';
import type { ValueUnit } from './value-axis.ts';

/** What a drag does, with the pointer where it is now. */
interface DragStep {
  /** What the step of undo is called. */
  readonly label: string;
  /** In words, while it goes on. */
  readonly telling: string;
  readonly edit: (clip: ClipParts) => EditedKeys;
}

/** Keys that are held while the pointer moves. */
export interface HeldKeys {
  readonly shift: boolean;
  readonly alt: boolean;
}

/** A drag from a place in the plot: what it does when the pointer is at another. */
export type Drag = (to: Place, held: HeldKeys) => DragStep;

/** What a drag knows of the editor when it begins. */
export interface DragStart {
  readonly from: Place;
  readonly plot: Plot;
  readonly selection: KeySelection;
  readonly scales: Scales;
  readonly fps: number;
  readonly snaps: boolean;
}

/**
 * Moves the selected keys in time and value; Shift keeps to the direction in which the pointer has
 * gone farther. Where times are those of frames, the pressed key comes to lie on one.
 */
export function movingKeys(start: DragStart, pressed: LineKey, unit: ValueUnit): Drag {
  const { from, plot, selection, scales, fps, snaps } = start;
  const { line, at } = pressed;
  const count = countOf(selection);
  const label = `Move ${keyCount(count)}`;
  return (to, { shift }) => {
    const isAcross = Math.abs(to.x - from.x) >= Math.abs(to.y - from.y);
    const [across, down] = [!shift || isAcross, !shift || !isAcross];
    const time = line.times[at]!;
    const free = across ? timeAt(plot, to.x) - timeAt(plot, from.x) : 0;
    const seconds = across && snaps ? atFrame(time + free, fps) - time : free;
    const plotted = down && line.slopes ? plottedAt(plot, to.y) - plottedAt(plot, from.y) : 0;
    const value = line.slopes ? plotted / line.scale.factor : null;
    return {
      label,
      telling: `${label}: ${movedText(seconds, fps, value, unit)}`,
      edit: (clip) => moveInPlot(clip, selection, scales, { seconds, plotted }),
    };
  };
}

/** Turns a handle; with both sides if they have one slope, unless Alt or a switch breaks them. */
export function turningHandle(
  { plot, selection }: DragStart,
  handle: SlopeHandle,
  breaks: boolean,
  unit: ValueUnit,
): Drag {
  const { line, at, side } = handle;
  const wasUnified = isUnified(line, at);
  const key = oneKey(line.key, line.times[at]!);
  return (to, { alt }) => {
    const slope = slopeToward(handle, to, plot);
    const isBoth = wasUnified && !breaks && !alt;
    const which = isBoth ? 'both sides' : side === 'in' ? 'before the key' : 'after the key';
    return {
      label: 'Turn a handle',
      telling: `Slope ${slopeText(slope, unit)}, ${which}`,
      edit: (clip) => ({
        clip: setTangents(clip, key, isBoth ? 'both' : side, slope),
        selection,
      }),
    };
  };
}

/** Scales the selected keys by a handle of their box, about its opposite side. */
export function scalingKeys(start: DragStart, box: Box, handle: BoxHandle): Drag {
  const { from, plot, selection, scales, fps, snaps } = start;
  const label = `Scale ${keyCount(countOf(selection))}`;
  return (to) => {
    const { about, acrossFactor, downFactor } = scalingOf(box, handle, from, to);
    const aboutTime = timeAt(plot, about.x);
    const edge = timeAt(plot, about.x + scalingExtent(box, handle, about));
    const timeFactor = snaps ? snappedFactor(aboutTime, edge, acrossFactor, fps) : acrossFactor;
    const aboutPlotted = plottedAt(plot, about.y);
    const scaling = { aboutTime, timeFactor, aboutPlotted, valueFactor: downFactor };
    const parts = [
      ...(handle.across === 0 ? [] : [`${percent(timeFactor)} of the time`]),
      ...(handle.down === 0 ? [] : [`${percent(downFactor)} of the value`]),
    ];
    return {
      label,
      telling: `${label}: ${parts.join(', ')}`,
      edit: (clip) => scaleInPlot(clip, selection, scales, scaling),
    };
  };
}

/** How far to the right of the fixed side the keys at the dragged side are, in pixels. */
function scalingExtent(box: Box, { across }: BoxHandle, about: Place): number {
  const middle = (box.left + box.right) / 2;
  return across * 2 * Math.abs(middle - about.x);
}

/** The factor by which the keys at the dragged side come to lie on a frame. */
function snappedFactor(about: number, edge: number, factor: number, fps: number): number {
  const extent = edge - about;
  if (factor === 1 || Math.abs(extent) < 1e-9) return factor;
  return (atFrame(about + extent * factor, fps) - about) / extent;
}

function percent(factor: number): string {
  return `${Math.round(factor * 100)} %`;
}

export function countOf(selection: KeySelection): number {
  return [...selection.values()].reduce((sum, times) => sum + times.length, 0);
}
