import { type Channel, channelFor, evaluateChannel } from './channel.ts';
import { type ChannelParts, type ClipParts, isRotationChannel } from './clip-parts.ts';
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

/**
 * Slopes and cubics are computed once, so that playing allocates nothing; of an edited clip only
 * those of its edited curves.
 */
function compileClip(parts: ClipParts, thing: AnimatedThing): Clip {
  const { name, start, end, fps, channels } = parts;
  const curves = { q: [], morphWeights: [], pins: [] } as Record<SlotList, SlotCurve[]>;
  const rotations: RotationTrack[] = [];
  for (const channel of channels) {
    const curve = curveFor(channel, thing);
    if (!curve) continue;
    if ('list' in curve) curves[curve.list].push(curve);
    else rotations.push(curve);
  }
  return { name, start, end, fps, curves, rotations };
}

/** Returns null if the character does not have what the channel moves. */
function curveFor(channel: ChannelParts, thing: AnimatedThing): SlotCurve | RotationTrack | null {
  let known = curvesOf.get(thing);
  if (!known) curvesOf.set(thing, (known = new WeakMap()));
  let curve = known.get(channel);
  if (curve === undefined) known.set(channel, (curve = compileCurve(channel, thing)));
  return curve;
}

const curvesOf = new WeakMap<
  AnimatedThing,
  WeakMap<ChannelParts, SlotCurve | RotationTrack | null>
>();

function compileCurve(channel: ChannelParts, thing: AnimatedThing) {
  if (isRotationChannel(channel)) return rotationTrack(channel, thing.skeleton);
  const slot = channel.target && slotOf(channel.target, thing);
  return slot && { ...slot, channel: channelFor(channel) };
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
