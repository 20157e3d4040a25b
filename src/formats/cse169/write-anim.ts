import type { ScalarChannelParts, ScalarClipParts, Tangent } from '../../core/motion/clip-parts.ts';
import { slopesOf } from '../../core/motion/tangents.ts';
import { encodeLines, writeFloat64 } from '../text/write-number.ts';

/** Writes an `.anim` with the channels in order and the tangents of the keys. */
export function writeAnim({ start, end, channels }: ScalarClipParts): Uint8Array {
  return encodeLines([
    'animation {',
    `\trange ${writeFloat64(start)} ${writeFloat64(end)}`,
    `\tnumchannels ${channels.length}`,
    ...channels.flatMap(channelLines),
    '}',
  ]);
}

function channelLines({ before, after, keys }: ScalarChannelParts): string[] {
  const { slopesIn, slopesOut } = slopesOf(keys);
  return [
    '\tchannel {',
    `\t\textrapolate ${before} ${after}`,
    `\t\tkeys ${keys.length} {`,
    ...keys.map(({ time, value, tangentIn, tangentOut }, at) => {
      const words = [writeFloat64(time), writeFloat64(value), tangent(tangentIn, slopesIn[at]!)];
      return `\t\t\t${[...words, tangent(tangentOut, slopesOut[at]!)].join(' ')}`;
    }),
    '\t\t}',
    '\t}',
  ];
}

/** The word of a rule that the format has, otherwise the slope that it gives. */
function tangent(value: Tangent, slope: number): string {
  const isWord = value === 'flat' || value === 'linear' || value === 'smooth';
  return isWord ? value : writeFloat64(slope);
}
