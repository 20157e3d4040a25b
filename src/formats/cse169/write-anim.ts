import type { ChannelParts, ClipParts, Tangent } from '../../core/character-parts.ts';
import { encodeLines, writeFloat64 } from '../text/write-number.ts';

/** Writes an `.anim` with the channels in order and the tangents of the keys. */
export function writeAnim({ start, end, channels }: ClipParts): Uint8Array {
  return encodeLines([
    'animation {',
    `\trange ${writeFloat64(start)} ${writeFloat64(end)}`,
    `\tnumchannels ${channels.length}`,
    ...channels.flatMap(channelLines),
    '}',
  ]);
}

function channelLines({ before, after, keys }: ChannelParts): string[] {
  return [
    '\tchannel {',
    `\t\textrapolate ${before} ${after}`,
    `\t\tkeys ${keys.length} {`,
    ...keys.map(({ time, value, tangentIn, tangentOut }) => {
      const words = [writeFloat64(time), writeFloat64(value), tangent(tangentIn)];
      return `\t\t\t${[...words, tangent(tangentOut)].join(' ')}`;
    }),
    '\t\t}',
    '\t}',
  ];
}

function tangent(value: Tangent): string {
  return typeof value === 'number' ? writeFloat64(value) : value;
}
