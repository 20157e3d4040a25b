import type { Character } from '../../core/character.ts';
import { defaultLimits } from '../../core/limits.ts';
import {
  type ChannelParts,
  type ChannelTarget,
  type Extrapolation,
  isRotationChannel,
  type KeyParts,
  type Quaternion,
  type RotationKeyParts,
  type RotationTarget,
  type Tangent,
  type Tcb,
} from '../../core/motion/clip-parts.ts';
import type { JsonValue } from '../../formats/json/decoder.ts';
import { printedOnce } from '../../formats/json/print-json.ts';
import { targetKinds } from '../../formats/motion/target-kinds.ts';
import { checked, type Codec, numbers, numberWithin, oneOf } from './codec.ts';

const { coordinate } = defaultLimits;

const finite = numberWithin(-coordinate, coordinate);

const extrapolation = oneOf<Extrapolation>([
  ...(['constant', 'linear', 'cycle', 'cycle_offset', 'bounce'] as const),
]);

const rule = oneOf(['flat', 'linear', 'smooth', 'auto', 'stepped'] as const);

const rotation = checked(
  numbers<Quaternion>(4, 1.001),
  (quaternion) => Math.abs(Math.hypot(...quaternion) - 1) < 1e-3,
  'a quaternion of length 1',
);

/** The tension, continuity and bias of `["tcb", T, C, B]`. */
const tcb: Codec<Tcb> = {
  write: (value) => ['tcb', ...value],
  read(json) {
    const expected = 'a slope, a rule for it, or ["tcb", T, C, B]';
    const [name, ...values] = json.list(4, expected) ?? [];
    if (!name) return undefined;
    if (name.value === 'tcb' && values.length === 3) {
      const read = values.map((each) => finite.read(each));
      return read.includes(undefined) ? undefined : (read as readonly number[] as Tcb);
    }
    json.fail('json', expected);
    return undefined;
  },
};

const tangent: Codec<Tangent> = {
  write: (value) => (typeof value === 'object' ? tcb.write(value.tcb) : value),
  read(json) {
    if (typeof json.value === 'number') return finite.read(json);
    if (typeof json.value === 'string') return rule.read(json);
    const read = tcb.read(json);
    return read && { tcb: read };
  },
};

/** More keys than a channel is edited with. */
const mostKeys = 1_000_000;

/** Writes a channel; absent ends are constant, and absent tangents auto. */
export function writeChannel(channel: ChannelParts, character: Character): unknown {
  const { target, before, after } = channel;
  return {
    target: writeTarget(target, character),
    ...((before !== 'constant' || after !== 'constant') && { extrapolate: [before, after] }),
    keys: writtenKeys(channel),
  };
}

/** A scene is written after every change, but most of its channels stay the same. */
function writtenKeys(channel: ChannelParts): unknown {
  let keys = written.get(channel);
  if (!keys) {
    const all: readonly unknown[] = isRotationChannel(channel)
      ? channel.keys.map(({ time, value }) => [time, value])
      : channel.keys.map(writeKey);
    written.set(channel, (keys = printedOnce(all)));
  }
  return keys;
}

const written = new WeakMap<ChannelParts, unknown>();

function writeKey({ time, value, tangentIn, tangentOut }: KeyParts): unknown {
  const isPlain = tangentIn === 'auto' && tangentOut === 'auto';
  const tangents = isPlain ? [] : [tangent.write(tangentIn), tangent.write(tangentOut)];
  return [time, value, ...tangents];
}

/** Reads a channel; one with anything wrong is reported and left out. */
export function readChannel(json: JsonValue, character: Character): ChannelParts | undefined {
  const members = json.record('a channel');
  if (!members) return undefined;
  const target = readTarget(json.member('target'), character);
  const ends = members.get('extrapolate');
  const rules = ends ? readEnds(ends) : (['constant', 'constant'] as const);
  if (target === undefined || !rules) return undefined;
  const [before, after] = rules;
  const list = json.member('keys');
  if (isRotation(target)) {
    const keys = readKeys(list, readRotationKey);
    return keys && { target, before, after, keys };
  }
  const keys = readKeys(list, readKey);
  return keys && { target, before, after, keys };
}

/** What a channel moves, as MOTION.json has it; null if the character has nothing for it. */
function writeTarget(target: ChannelTarget | null, character: Character): unknown {
  return target && targetKinds.map((kind) => kind.write(target, character)).find(Boolean);
}

/**
 * Returns null for a channel that moves nothing, and nothing if the target is wrong, which is
 * reported. A file's clip may move joints that the character lacks.
 */
function readTarget(json: JsonValue, character: Character): ChannelTarget | null | undefined {
  if (json.value === null) return null;
  const fields = json.record('what the channel moves');
  const kind = fields && targetKinds.find((each) => each.matches(fields));
  if (fields && !kind) json.fail('json', 'a target as MOTION.json has it');
  return kind?.read(fields!)?.locate(character, json);
}

function isRotation(target: ChannelTarget | null): target is RotationTarget {
  return target?.of === 'rotation';
}

function readEnds(json: JsonValue): readonly [Extrapolation, Extrapolation] | undefined {
  const ends = json
    .list(2, 'the rules before and after the keys')
    ?.map((end) => extrapolation.read(end));
  const [before, after] = ends ?? [];
  if (before && after) return [before, after];
  if (ends?.length !== 2) json.fail('json', 'the rules before and after the keys');
  return undefined;
}

function readKeys<Key extends { readonly time: number }>(
  json: JsonValue,
  read: (json: JsonValue) => Key | undefined,
): readonly Key[] | undefined {
  const keys: Key[] = [];
  for (const item of json.list(mostKeys, 'a list of keys') ?? [undefined]) {
    const key = item && read(item);
    if (!key) return undefined;
    const last = keys.at(-1);
    if (last && last.time >= key.time) {
      item.fail('range', 'a time after that of the key before');
      return undefined;
    }
    keys.push(key);
  }
  return keys;
}

function readKey(json: JsonValue): KeyParts | undefined {
  const items = json.list(4, 'a key as [time, value, in, out]');
  if (!items) return undefined;
  const [time, value] = [finite.read(json.member(0)), finite.read(json.member(1))];
  const tangentIn = items[2] ? tangent.read(items[2]) : 'auto';
  const tangentOut = items[3] ? tangent.read(items[3]) : 'auto';
  if (time === undefined || value === undefined) return undefined;
  if (tangentIn === undefined || tangentOut === undefined) return undefined;
  return { time, value, tangentIn, tangentOut };
}

function readRotationKey(json: JsonValue): RotationKeyParts | undefined {
  if (!json.list(2, 'a key as [time, [x, y, z, w]]')) return undefined;
  const [time, value] = [finite.read(json.member(0)), rotation.read(json.member(1))];
  return time === undefined || !value ? undefined : { time, value };
}
