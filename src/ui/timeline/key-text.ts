import { evaluateChannel, channelFor } from '../../core/motion/channel.ts';
import { type ChannelParts, isRotationChannel } from '../../core/motion/clip-parts.ts';
import { keyAt } from '../../core/motion/edit/keys.ts';
import { DofKind } from '../../core/skeleton.ts';
import { formatDegrees } from '../angle-text.ts';
import { fixedText } from '../number-text.ts';
import { keysOfRow } from './row-keys.ts';
import type { TimelineRow } from './rows.ts';
import { timeText, type TimeUnit } from './timeline-state.ts';

/** Says a key of a row: "Right elbow X, key 3 of 5, 0.50 s, 30.0°". */
export function keyText(row: TimelineRow, at: number, fps: number, unit: TimeUnit): string {
  const { times } = keysOfRow(row.channels);
  const time = times[at]!;
  const place =
    unit === 'frames' ? `frame ${timeText(time, fps, unit)}` : timeText(time, fps, unit);
  const what = row.kind === 'channel' ? valueText(row.channels[0]!, time) : countText(row, time);
  return `${row.fullName}, key ${at + 1} of ${times.length}, ${place}, ${what}`;
}

/** The value of a channel at the time of a key: an angle in degrees, or a number. */
function valueText(channel: ChannelParts, time: number): string {
  if (isRotationChannel(channel)) {
    const { value } = channel.keys[Math.max(0, keyAt(channel.keys, time))]!;
    return `turned by ${formatDegrees(2 * Math.acos(Math.min(1, Math.abs(value[3]))))}`;
  }
  const { target } = channel;
  const value = evaluateChannel(channelFor(channel), time);
  const isAngle = target?.of === 'value' && target.kind === DofKind.hinge;
  return isAngle ? formatDegrees(value) : fixedText(value);
}

function countText({ channels }: TimelineRow, time: number): string {
  const count = channels.filter(({ keys }) => keyAt(keys, time) >= 0).length;
  return count === 1 ? 'one value' : `${count} values`;
}
