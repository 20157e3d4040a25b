import { DiagnosticLog, type Parsed, type Place } from '../../core/diagnostics.ts';
import type {
  ChannelParts,
  ChannelTarget,
  ClipParts,
  RotationTarget,
  ScalarTarget,
} from '../../core/motion/clip-parts.ts';
import { type AnimatedThing, channelKey } from '../../core/motion/targets.ts';
import { DofKind } from '../../core/skeleton.ts';
import type { Motion, MotionChannel, NamedCurve } from './motion.ts';
import { kept } from './read-channel.ts';

export interface BoundMotion extends Parsed<ClipParts> {
  /** Where the file first moves the pin of a joint, by the joint's file index, for messages. */
  readonly pinPlaces?: ReadonlyMap<number, Place>;
}

/**
 * Finds what a motion moves in a character. A channel whose target the character does not have is
 * reported and kept for saving.
 */
export function bindMotion(motion: Motion, thing: AnimatedThing): BoundMotion {
  const { file, name, start, end, fps } = motion;
  const log = new DiagnosticLog(file);
  const unread = [...motion.unread];
  const pinPlaces = new Map<number, Place>();
  const found = new Map<string, { channel: MotionChannel; parts: ChannelParts }>();
  for (const channel of motion.channels) {
    const place = channel.place.reporting({ log, effect: kept });
    const target = channel.target.locate(thing, place);
    if (!target || !channel.target.check(thing, place)) {
      unread.push(channel.raw);
      continue;
    }
    if (target.of === 'pin' && !pinPlaces.has(target.joint)) {
      pinPlaces.set(target.joint, place.member('pin').place);
    }
    const key = channelKey(target);
    const earlier = found.get(key)?.channel.target.names[0];
    if (earlier !== undefined) {
      place.warn('duplicate', 'one channel for each target', earlier, 'the last one counts');
      found.delete(key);
    }
    found.set(key, { channel, parts: withTarget(channel.curve, target) });
  }
  for (const [key, { channel, parts }] of found) {
    if (!isTurnedOtherwise(parts, found)) continue;
    const place = channel.place.reporting({ log });
    const [name] = channel.target.names;
    place.warn('duplicate', 'angles or a rotation of a joint', name, 'its rotation counts');
    found.delete(key);
  }
  const channels = Array.from(found.values(), ({ parts }) => parts);
  return {
    value: { file, name, start, end, fps, channels, ...(unread.length > 0 && { unread }) },
    diagnostics: log.diagnostics,
    pinPlaces,
  };
}

/** Whether a channel is an angle of a joint whose whole rotation another channel has. */
function isTurnedOtherwise(
  { target }: ChannelParts,
  others: ReadonlyMap<string, unknown>,
): boolean {
  if (target?.of !== 'value' || target.kind !== DofKind.hinge) return false;
  return others.has(channelKey({ of: 'rotation', joint: target.joint, curve: 'slerp' }));
}

function withTarget(curve: NamedCurve, target: ChannelTarget): ChannelParts {
  const { before, after } = curve;
  if (curve.of === 'rotation') {
    return { target: target as RotationTarget, before, after, keys: curve.keys };
  }
  return { target: target as ScalarTarget, before, after, keys: curve.keys };
}
