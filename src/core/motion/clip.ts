import { type Channel, channelFor, evaluateChannel } from './channel.ts';
import { type ClipParts, isRotationChannel } from './clip-parts.ts';
import { type RotationTrack, evaluateTrack, rotationTrack } from './rotation-track.ts';
import { type AnimatedThing, type Slot, type SlotList, slotOf } from './targets.ts';

/** An animation compiled for one character: curves for some of its values. It never changes. */
export interface Clip {
  readonly name: string;
  /** The range that is played, in seconds. */
  readonly start: number;
  readonly end: number;
  readonly fps: number;
  /** The curves that the character has a value for, by the list that they are written into. */
  readonly curves: Readonly<Record<SlotList, readonly SlotCurve[]>>;
  readonly rotations: readonly RotationTrack[];
}

export interface SlotCurve extends Slot {
  readonly channel: Channel;
}

/** Values of a character that a clip writes. */
export interface ClipValues {
  /** (qCount) */
  q: Float64Array;
  /** (morphCount) */
  morphWeights: Float64Array;
  /** (jointCount × 4) x, y, z and weight of the pin of each joint. */
  pins: Float64Array;
}

/**
 * Returns the clip compiled for a character. It is compiled on first use and cached while both
 * exist; curves that another clip has too are not compiled again.
 */
export function clipFor(parts: ClipParts, thing: AnimatedThing): Clip {
  let clips = compiled.get(thing);
  if (!clips) compiled.set(thing, (clips = new WeakMap<ClipParts, Clip>()));
  let clip = clips.get(parts);
  if (!clip) clips.set(parts, (clip = compileClip(parts, thing)));
  return clip;
}

const compiled = new WeakMap<AnimatedThing, WeakMap<ClipParts, Clip>>();

/** Slopes and cubics are computed once, here, so that playing allocates nothing. */
function compileClip(parts: ClipParts, thing: AnimatedThing): Clip {
  const { name, start, end, fps, channels } = parts;
  const rotations = channels.flatMap((each) =>
    isRotationChannel(each) ? (rotationTrack(each, thing.skeleton) ?? []) : [],
  );
  const all = channels.flatMap((each): readonly SlotCurve[] => {
    if (isRotationChannel(each) || !each.target) return [];
    const slot = slotOf(each.target, thing);
    return slot ? [{ ...slot, channel: channelFor(each) }] : [];
  });
  const of = (list: SlotList): readonly SlotCurve[] => all.filter((each) => each.list === list);
  const curves = { q: of('q'), morphWeights: of('morphWeights'), pins: of('pins') };
  return { name, start, end, fps, curves, rotations };
}

/**
 * Writes the clip's values at a time, clamped to their limits. Other values do not change.
 *
 * @param time in seconds; outside its keys each channel continues by its own extrapolation
 * @param values of the character that the clip was compiled for
 */
export function evaluateClip({ curves, rotations }: Clip, time: number, values: ClipValues): void {
  writeCurves(curves.q, time, values.q);
  writeCurves(curves.morphWeights, time, values.morphWeights);
  writeCurves(curves.pins, time, values.pins);
  for (let i = 0; i < rotations.length; i++) evaluateTrack(rotations[i]!, time, values.q);
}

function writeCurves(curves: readonly SlotCurve[], time: number, values: Float64Array): void {
  for (let i = 0; i < curves.length; i++) {
    const { channel, index, minimum, maximum } = curves[i]!;
    values[index] = Math.min(Math.max(evaluateChannel(channel, time), minimum), maximum);
  }
}
