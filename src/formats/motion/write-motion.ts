import {
  type ChannelParts,
  type ChannelTarget,
  type ClipParts,
  isRotationChannel,
  type KeyParts,
  type Tangent,
} from '../../core/motion/clip-parts.ts';
import type { AnimatedThing } from '../../core/motion/targets.ts';
import type { Written } from '../format.ts';
import { printJson } from '../json/print-json.ts';
import { lost } from '../lost.ts';
import { encodeLines } from '../text/write-number.ts';
import { targetKinds } from './target-kinds.ts';

/**
 * Writes a clip as MOTION.json, a key a line. Reading it gives the same clip, bit by bit. Channels
 * that were kept because nothing could read them are written as they were.
 */
export function writeMotion(clip: ClipParts, thing: AnimatedThing): Written {
  const path = `${clip.name}.motion.json`;
  const described = clip.channels.map((channel) => describe(channel, thing));
  const channels = [
    ...described.flatMap((each) => (each ? [channelText(each)] : [])),
    ...(clip.unread ?? []).map((each) => `    ${printJson(each)}`),
  ];
  const lines = [
    '{',
    '  "version": 1,',
    `  "fps": ${printJson(clip.fps)},`,
    `  "range": [${printJson(clip.start)}, ${printJson(clip.end)}],`,
    ...(channels.length > 0
      ? ['  "channels": [', channels.join(',\n'), '  ]']
      : ['  "channels": []']),
    '}',
  ];
  const leftOut = described.filter((each) => each === undefined).length;
  const expected = 'channels of values that the character has';
  const found = `${leftOut} others`;
  const losses = leftOut > 0 ? [lost(path, expected, found, 'they are left out')] : [];
  return { files: [{ path, bytes: encodeLines(lines) }], losses };
}

interface Described {
  readonly target: Readonly<Record<string, unknown>>;
  readonly channel: ChannelParts;
}

function describe(channel: ChannelParts, thing: AnimatedThing): Described | undefined {
  const { target } = channel;
  if (!target || !isThere(target, thing)) return undefined;
  for (const kind of targetKinds) {
    const written = kind.write(target, thing);
    if (written) return { target: written, channel };
  }
  return undefined;
}

/** Whether a character has the joint or the morph that a channel moves. */
function isThere(target: ChannelTarget, { skeleton, morphs }: AnimatedThing): boolean {
  if (target.of === 'morph') return target.morph < morphs.length;
  return skeleton.jointOfSource[target.joint] !== undefined;
}

function channelText({ target, channel }: Described): string {
  const { before, after } = channel;
  const isPlain = before === 'constant' && after === 'constant';
  const rules = isPlain ? '' : `"extrapolate": ["${before}", "${after}"], `;
  const keys: readonly unknown[] = isRotationChannel(channel)
    ? channel.keys.map(({ time, value }) => [time, value])
    : channel.keys.map(keyJson);
  const head = `    {"target": ${spaced(target)}, ${rules}"keys": [`;
  if (keys.length === 0) return `${head}]}`;
  return [head, keys.map((key) => `      ${spaced(key)}`).join(',\n'), '    ]}'].join('\n');
}

function keyJson({ time, value, tangentIn, tangentOut }: KeyParts): readonly unknown[] {
  const isAuto = tangentIn === 'auto' && tangentOut === 'auto';
  return isAuto ? [time, value] : [time, value, tangentJson(tangentIn), tangentJson(tangentOut)];
}

function tangentJson(tangent: Tangent): unknown {
  return typeof tangent === 'object' ? ['tcb', ...tangent.tcb] : tangent;
}

/** JSON on one line with blanks after commas and colons. */
function spaced(value: unknown): string {
  if (Array.isArray(value)) return `[${value.map(spaced).join(', ')}]`;
  if (typeof value === 'object' && value !== null) {
    const members = Object.entries(value).map(
      ([key, member]) => `${JSON.stringify(key)}: ${spaced(member)}`,
    );
    return `{${members.join(', ')}}`;
  }
  return printJson(value);
}
