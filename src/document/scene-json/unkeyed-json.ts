import type { Character } from '../../core/character.ts';
import { defaultLimits } from '../../core/limits.ts';
import { jointRange } from '../../core/pose.ts';
import type { JsonValue } from '../../formats/json/decoder.ts';
import { findJoint } from '../../formats/pose-json.ts';
import type { Unkeyed } from '../../posing/unkeyed.ts';
import { index, numberWithin } from './codec.ts';
import { indexOfKey, keyAt } from '../../formats/json/keys.ts';

const seconds = numberWithin(-defaultLimits.coordinate, defaultLimits.coordinate);

/** Writes what is unkeyed: the values by joint, counted from its first one, and names. */
export function writeUnkeyed(unkeyed: Unkeyed, character: Character): Record<string, unknown> {
  const { skeleton, morphs } = character;
  const keyOf = (joint: number): string =>
    keyAt(skeleton.names, joint, skeleton.sourceIndex[joint]);
  const names = morphs.map(({ name }) => name);
  const values: [string, number[]][] = [];
  for (let joint = 0; joint < skeleton.jointCount; joint++) {
    const [from, to] = jointRange(skeleton, joint);
    const own = unkeyed.values.filter((at) => at >= from && at < to).map((at) => at - from);
    if (own.length > 0) values.push([keyOf(joint), own]);
  }
  return {
    time: unkeyed.time,
    // Built from entries, because a joint may have any name, even "__proto__".
    ...(values.length > 0 && { values: Object.fromEntries(values) }),
    ...(unkeyed.morphs.length > 0 && { morphs: unkeyed.morphs.map((at) => keyAt(names, at)) }),
    ...(unkeyed.pins.length > 0 && { pins: unkeyed.pins.map(keyOf) }),
  };
}

/** Reads what is unkeyed; what the character does not have is reported and left out. */
export function readUnkeyed(
  json: JsonValue,
  { skeleton, morphs }: Character,
  pinned: readonly number[],
): Unkeyed | null {
  const members = json.record('what is unkeyed');
  const time = members && seconds.read(json.member('time'));
  if (time === undefined) return null;
  const names = morphs.map(({ name }) => name);
  const values = [...(members?.get('values')?.record('values by joint') ?? [])];
  const listed = (key: 'morphs' | 'pins'): readonly JsonValue[] =>
    members?.get(key)?.list(names.length + skeleton.jointCount, 'a list of names') ?? [];
  return {
    time,
    values: increasing(values.flatMap(([key, member]) => valuesOf(skeleton, key, member))),
    morphs: increasing(listed('morphs').flatMap((each) => morphOf(names, each))),
    pins: increasing(listed('pins').flatMap((each) => pinOf(skeleton, pinned, each))),
  };
}

function valuesOf(skeleton: Character['skeleton'], key: string, json: JsonValue): number[] {
  const joint = findJoint(skeleton, key);
  if (typeof joint === 'string') {
    json.failName('unknown-joint', joint, key);
    return [];
  }
  const [from, to] = jointRange(skeleton, joint);
  return (json.list(to - from, 'indices of its values') ?? []).flatMap((item) => {
    const at = index.read(item);
    if (at === undefined) return [];
    if (at < to - from) return from + at;
    item.fail('index', `an index of the ${to - from} values of "${key}"`);
    return [];
  });
}

function morphOf(names: readonly string[], json: JsonValue): number | [] {
  const found = typeof json.value === 'string' ? indexOfKey(names, json.value) : -1;
  if (found >= 0) return found;
  json.fail('unknown', 'the name of a morph, or # and its index');
  return [];
}

function pinOf(
  skeleton: Character['skeleton'],
  pinned: readonly number[],
  json: JsonValue,
): number | [] {
  const joint = typeof json.value === 'string' ? findJoint(skeleton, json.value) : -1;
  if (typeof joint === 'number' && pinned.includes(joint)) return joint;
  json.fail('unknown-joint', 'the name of a pinned joint');
  return [];
}

function increasing(indices: readonly number[]): readonly number[] {
  return [...new Set(indices)].sort((a, b) => a - b);
}
