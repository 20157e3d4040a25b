import type { KeyParts, Quaternion, RotationKeyParts } from '../../core/motion/clip-parts.ts';
import { sameTime } from '../../core/motion/edit/keys.ts';
import { defaultLimits } from '../../core/limits.ts';
import { quaternionOf } from '../ball-values.ts';
import type { JsonValue } from '../json/decoder.ts';
import { isWithin, numberIn } from './fields.ts';
import { plainTangent, readTangent } from './read-tangent.ts';

/** A limit that no real motion reaches. */
const mostKeys = 1_000_000;
/** In seconds. */
export const largestTime = 1e9;

/** Reads the keys of a number: `[t, v]` or `[t, v, in, out]`. */
export function readNumberKeys(json: JsonValue): readonly KeyParts[] | undefined {
  const expected = 'a key as [time, value] or [time, value, in, out]';
  return readAll(json, { lengths: [2, 3, 4], expected, plain: plainKey }, (key, time) => {
    const value = numberIn(key.member(1), defaultLimits.coordinate, 'a value');
    const tangentIn = tangentOf(key, 2);
    const tangentOut = tangentOf(key, 3);
    if (value === undefined || tangentIn === undefined || tangentOut === undefined)
      return undefined;
    return { time, value, tangentIn, tangentOut };
  });
}

/** A key whose tangents are no lists, which most are. Values that report faults are made for others. */
function plainKey([time, value, tangentIn, tangentOut]: readonly unknown[]): KeyParts | undefined {
  const [before, after] = [plainTangent(tangentIn), plainTangent(tangentOut)];
  const isPlain = isWithin(time, largestTime) && isWithin(value, defaultLimits.coordinate);
  if (!isPlain || before === undefined || after === undefined) return undefined;
  return { time, value, tangentIn: before, tangentOut: after };
}

function tangentOf(key: JsonValue, at: number) {
  const isThere = at < (key.value as readonly unknown[]).length;
  return isThere ? readTangent(key.member(at)) : 'auto';
}

/** Reads the keys of a rotation: `[t, [x, y, z, w]]`, whose quaternions are normalized. */
export function readTurnKeys(json: JsonValue): readonly RotationKeyParts[] | undefined {
  const form: Form<RotationKeyParts> = { lengths: [2], expected: 'a key as [time, [x, y, z, w]]' };
  return readAll(json, form, (key, time) => {
    const value = readQuaternion(key.member(1));
    return value && { time, value };
  });
}

function readQuaternion(json: JsonValue): Quaternion | undefined {
  const values = json.numbers([4], 'a quaternion as [x, y, z, w]');
  if (!values) return undefined;
  const largest = defaultLimits.coordinate;
  if (values.some((value) => Math.abs(value) > largest)) {
    json.fail('range', 'a quaternion of numbers within ±1e18');
    return undefined;
  }
  const unit = quaternionOf(values as [number, number, number, number]);
  if (unit.every(Number.isFinite)) return unit;
  json.fail('range', 'a quaternion with a length');
  return undefined;
}

interface Form<Key> {
  /** How many items a key may have, and what is expected of others. */
  readonly lengths: readonly number[];
  readonly expected: string;
  /** Reads most keys that have nothing wrong. */
  readonly plain?: (key: readonly unknown[]) => Key | undefined;
}

/** Reads all keys and sorts them, or reports the first that is wrong. */
function readAll<Key extends { readonly time: number }>(
  json: JsonValue,
  { lengths, expected, plain }: Form<Key>,
  read: (key: JsonValue, time: number) => Key | undefined,
): readonly Key[] | undefined {
  if (!Array.isArray(json.value)) {
    json.fail('json', '"keys" to be a list');
    return undefined;
  }
  const { length } = json.value;
  if (length > mostKeys) {
    json.fail('limit', `at most ${mostKeys} keys`, `${length}`);
    return undefined;
  }
  const keys: Key[] = [];
  for (let at = 0; at < length; at++) {
    const item: unknown = json.value[at];
    const known = Array.isArray(item) && lengths.includes(item.length) ? plain?.(item) : undefined;
    if (known) {
      keys.push(known);
      continue;
    }
    const key = json.member(at);
    if (!Array.isArray(key.value) || !lengths.includes(key.value.length)) {
      key.fail('json', expected);
      return undefined;
    }
    const time = numberIn(key.member(0), largestTime, 'a time in seconds');
    const own = time === undefined ? undefined : read(key, time);
    if (!own) return undefined;
    keys.push(own);
  }
  if (length === 0) {
    json.warn('empty', 'at least one key', 'none', 'the value is 0 at all times');
  }
  return rising(keys, json);
}

/** Sorts keys by time; of several at one time the last one counts. */
function rising<Key extends { readonly time: number }>(
  keys: readonly Key[],
  json: JsonValue,
): readonly Key[] {
  const early = keys.findIndex((key, at) => at > 0 && keys[at - 1]!.time > key.time);
  if (early > 0) {
    const found = `${keys[early]!.time} after ${keys[early - 1]!.time}`;
    json.member(early).warn('order', 'keys at rising times', found, 'they are sorted');
  }
  const sorted = early > 0 ? keys.toSorted((a, b) => a.time - b.time) : keys;
  const distinct: Key[] = [];
  let double: Key | undefined;
  for (const key of sorted) {
    const last = distinct.at(-1);
    if (last && sameTime(last.time, key.time)) {
      distinct.pop();
      double ??= key;
    }
    distinct.push(key);
  }
  if (double) {
    const place = json.member(keys.indexOf(double));
    const found = `${sorted.length - distinct.length} at the time of another`;
    place.warn('duplicate', 'one key at a time', found, 'the last one counts');
  }
  return distinct;
}
