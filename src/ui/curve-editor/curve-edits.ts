import {
  type ClipParts,
  isRotationChannel,
  type ScalarChannelParts,
} from '../../core/motion/clip-parts.ts';
import { channelFor } from '../../core/motion/channel.ts';
import { channelOf } from '../../core/motion/edit/channels.ts';
import { keyAt } from '../../core/motion/edit/keys.ts';
import { moveKeys, scaleKeys } from '../../core/motion/edit/move-keys.ts';
import type { EditedKeys } from '../../core/motion/edit/selection.ts';
import { changeKey } from '../../core/motion/edit/set-key.ts';
import { setTangents, type TangentSide } from '../../core/motion/edit/tangents.ts';
import type { KeySelection } from '../../core/motion/key-selection.ts';
import type { ChannelKey } from '../../core/motion/targets.ts';
import { changed, type TypedChange } from './key-text.ts';
import { type CurveScale, ownScale, valueOf } from './plot.ts';

export type Scales = ReadonlyMap<ChannelKey, CurveScale>;

/** Edits each channel of a selection by itself, because each is drawn at its own scale. */
function eachChannel(
  clip: ClipParts,
  selection: KeySelection,
  edit: (clip: ClipParts, selection: KeySelection, key: ChannelKey) => EditedKeys,
): EditedKeys {
  let edited = clip;
  const moved = new Map<ChannelKey, readonly number[]>();
  for (const [key, times] of selection) {
    const after = edit(edited, new Map([[key, times]]), key);
    edited = after.clip;
    for (const [at, times] of after.selection) moved.set(at, times);
  }
  return { clip: edited, selection: moved };
}

/** @param plotted how far keys move upward in the plot */
export function moveInPlot(
  clip: ClipParts,
  selection: KeySelection,
  scales: Scales,
  { seconds, plotted }: { readonly seconds: number; readonly plotted: number },
): EditedKeys {
  return eachChannel(clip, selection, (before, keys, key) => {
    const { factor } = scales.get(key) ?? ownScale;
    return moveKeys(before, keys, { seconds, value: plotted / factor });
  });
}

export interface PlotScaling {
  readonly aboutTime: number;
  readonly timeFactor: number;
  readonly aboutPlotted: number;
  readonly valueFactor: number;
}

export function scaleInPlot(
  clip: ClipParts,
  selection: KeySelection,
  scales: Scales,
  { aboutTime, timeFactor, aboutPlotted, valueFactor }: PlotScaling,
): EditedKeys {
  return eachChannel(clip, selection, (before, keys, key) => {
    const aboutValue = valueOf(scales.get(key) ?? ownScale, aboutPlotted);
    return scaleKeys(before, keys, { aboutTime, timeFactor, aboutValue, valueFactor });
  });
}

/** Sets, moves or multiplies the values of selected keys. */
export function changeValues(
  clip: ClipParts,
  selection: KeySelection,
  change: TypedChange,
): ClipParts {
  return eachKey(clip, selection, (before, key, time, { channel, at }) => {
    const value = changed(change, channel.keys[at]!.value);
    return changeKey(before, key, time, { value }).clip;
  });
}

/** Sets the tangents of selected keys to the slopes that they have, as numbers. */
export function fixSlopes(clip: ClipParts, selection: KeySelection, side: TangentSide): ClipParts {
  return eachKey(clip, selection, (before, key, time, { channel, at }) => {
    const { slopesIn, slopesOut } = channelFor(channel);
    return changeKey(before, key, time, {
      ...(side !== 'out' && { tangentIn: slopesIn[at]! }),
      ...(side !== 'in' && { tangentOut: slopesOut[at]! }),
    }).clip;
  });
}

/** Gives both sides of selected keys one slope, the mean of what they have. */
export function unifySlopes(clip: ClipParts, selection: KeySelection): ClipParts {
  return eachKey(clip, selection, (before, key, time, { channel, at }) => {
    const { slopesIn, slopesOut } = channelFor(channel);
    return setTangents(before, oneKey(key, time), 'both', (slopesIn[at]! + slopesOut[at]!) / 2);
  });
}

interface ChannelAndKey {
  readonly channel: ScalarChannelParts;
  readonly at: number;
}

/** Edits the selected keys of numbers one after the other, each as it was before all. */
function eachKey(
  clip: ClipParts,
  selection: KeySelection,
  edit: (clip: ClipParts, key: ChannelKey, time: number, found: ChannelAndKey) => ClipParts,
): ClipParts {
  let edited = clip;
  for (const [key, times] of selection) {
    const channel = channelOf(clip, key);
    if (!channel || isRotationChannel(channel)) continue;
    for (const time of times) {
      const at = keyAt(channel.keys, time);
      if (at >= 0) edited = edit(edited, key, time, { channel, at });
    }
  }
  return edited;
}

export function oneKey(key: ChannelKey, time: number): KeySelection {
  return new Map([[key, [time]]]);
}
