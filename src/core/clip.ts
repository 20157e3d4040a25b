import { type Channel, compileChannel, evaluateChannel } from './channel.ts';
import type { ChannelParts, ClipParts } from './character-parts.ts';
import { axisDofs } from './pose.ts';
import type { Skeleton } from './skeleton.ts';

/** An animation compiled for one skeleton: curves for some of the values in q. It never changes. */
export interface Clip {
  readonly name: string;
  /** The range that is played, in seconds. */
  readonly start: number;
  readonly end: number;
  readonly channels: readonly Channel[];
  /** (channelCount) index in q; -1 if the skeleton has no such value. */
  readonly targets: Int32Array;
  /** (channelCount) limits of that value of q. */
  readonly minimum: Float64Array;
  readonly maximum: Float64Array;
}

/**
 * Returns the clip compiled for a skeleton. It is compiled on first use and cached while both
 * exist.
 */
export function clipFor(parts: ClipParts, skeleton: Skeleton): Clip {
  let clips = compiled.get(skeleton);
  if (!clips) compiled.set(skeleton, (clips = new WeakMap<ClipParts, Clip>()));
  let clip = clips.get(parts);
  if (!clip) clips.set(parts, (clip = compileClip(parts, skeleton)));
  return clip;
}

const compiled = new WeakMap<Skeleton, WeakMap<ClipParts, Clip>>();

/** Slopes and cubics are computed once, here, so that playing allocates nothing. */
function compileClip(parts: ClipParts, skeleton: Skeleton): Clip {
  const targets = Int32Array.from(parts.channels, (channel) => targetOf(channel, skeleton));
  const limit = (limits: Float64Array, unlimited: number): Float64Array =>
    Float64Array.from(targets, (target) => limits[target] ?? unlimited);
  return {
    name: parts.name,
    start: parts.start,
    end: parts.end,
    channels: parts.channels.map(compileChannel),
    targets,
    minimum: limit(skeleton.qMin, -Infinity),
    maximum: limit(skeleton.qMax, Infinity),
  };
}

function targetOf({ target }: ChannelParts, skeleton: Skeleton): number {
  const joint = target ? skeleton.jointOfSource[target.joint] : undefined;
  if (!target || joint === undefined) return -1;
  const dof = axisDofs(skeleton, joint).find(
    ({ kind, axis }) => kind === target.kind && axis === target.axis,
  );
  return dof?.index ?? -1;
}

/**
 * Writes the clip's values at a time into q, clamped to the joints' limits. Other values of q do
 * not change.
 *
 * @param time in seconds; outside its keys each channel continues by its own extrapolation
 * @param q (qCount) of the skeleton that the clip was compiled for
 */
export function evaluateClip(clip: Clip, time: number, q: Float64Array): void {
  const { channels, targets, minimum, maximum } = clip;
  for (let i = 0; i < channels.length; i++) {
    const target = targets[i]!;
    if (target === -1) continue;
    const value = evaluateChannel(channels[i]!, time);
    q[target] = Math.min(Math.max(value, minimum[i]!), maximum[i]!);
  }
}
