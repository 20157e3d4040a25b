import type { Character } from '../../core/character.ts';
import type { ChannelTarget, PinValue, RotationCurve } from '../../core/motion/clip-parts.ts';
import { pinValues } from '../../core/motion/targets.ts';
import { DofKind, type Skeleton } from '../../core/skeleton.ts';
import type { JsonValue } from '../../formats/json/decoder.ts';
import { findJoint } from '../../formats/pose-json.ts';
import { oneOf, text } from './codec.ts';
import { indexOfKey, keyAt } from '../../formats/json/keys.ts';

type Members = Readonly<Record<string, unknown>>;

const values = ['tx', 'ty', 'tz', 'rx', 'ry', 'rz'] as const;

const valueName = oneOf(values);
const pinValue = oneOf<PinValue>(pinValues);
const curve = oneOf<RotationCurve>(['slerp', 'squad']);

/** Writes what a channel moves as MOTION.json does: `{"joint": "Neck", "value": "rx"}`. */
export function writeTarget(target: ChannelTarget | null, character: Character): Members | null {
  if (!target) return null;
  const { skeleton, morphs } = character;
  switch (target.of) {
    case 'value': {
      const letter = target.kind === DofKind.slide ? 't' : 'r';
      const value = `${letter}${'xyz'[target.axis]!}`;
      return { joint: sourceKey(skeleton, target.joint), value };
    }
    case 'rotation':
      return { joint: sourceKey(skeleton, target.joint), rotation: target.curve };
    case 'morph': {
      const names = morphs.map(({ name }) => name);
      const { morph } = target;
      return { morph: morph < names.length ? keyAt(names, morph) : `#${morph}` };
    }
    case 'pin':
      return { pin: sourceKey(skeleton, target.joint), value: target.value };
  }
}

/** Returns nothing if it is none, which is reported, and null for a channel that moves nothing. */
export function readTarget(
  json: JsonValue,
  character: Character,
): ChannelTarget | null | undefined {
  if (json.value === null) return null;
  const members = json.record('what the channel moves');
  if (!members) return undefined;
  const [joint, morph, pin] = ['joint', 'morph', 'pin'].map((key) => members.get(key));
  if (morph) {
    const index = readMorph(morph, character);
    return index === undefined ? undefined : { of: 'morph', morph: index };
  }
  if (pin) {
    const [at, value] = [readSource(pin, character.skeleton), pinValue.read(json.member('value'))];
    return at === undefined || !value ? undefined : { of: 'pin', joint: at, value };
  }
  if (!joint) {
    json.fail('json', '"joint", "morph" or "pin"');
    return undefined;
  }
  const at = readSource(joint, character.skeleton);
  const rotation = members.get('rotation');
  if (rotation) {
    const way = curve.read(rotation);
    return at === undefined || !way ? undefined : { of: 'rotation', joint: at, curve: way };
  }
  const name = valueName.read(json.member('value'));
  if (at === undefined || !name) return undefined;
  const axis = 'xyz'.indexOf(name[1]!) as 0 | 1 | 2;
  return {
    of: 'value',
    joint: at,
    kind: name.startsWith('t') ? DofKind.slide : DofKind.hinge,
    axis,
  };
}

/** A file's clip may move joints that the character lacks; these are written by their index. */
function sourceKey({ names, jointOfSource, sourceIndex }: Skeleton, source: number): string {
  const joint = jointOfSource[source];
  return joint === undefined ? `#${source}` : keyAt(names, joint, sourceIndex[joint]);
}

function readSource(json: JsonValue, skeleton: Skeleton): number | undefined {
  const key = text.read(json);
  if (key === undefined) return undefined;
  if (/^#\d{1,6}$/.test(key)) return Number(key.slice(1));
  const joint = findJoint(skeleton, key);
  if (typeof joint === 'number') return skeleton.sourceIndex[joint];
  json.fail('unknown-joint', joint);
  return undefined;
}

function readMorph(json: JsonValue, { morphs }: Character): number | undefined {
  const key = text.read(json);
  if (key === undefined) return undefined;
  if (/^#\d{1,6}$/.test(key)) return Number(key.slice(1));
  const names = morphs.map(({ name }) => name);
  const index = indexOfKey(names, key);
  if (index >= 0) return index;
  json.fail('unknown', 'the name of a morph, or # and its index');
  return undefined;
}
