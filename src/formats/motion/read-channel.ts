import type { Extrapolation } from '../../core/motion/clip-parts.ts';
import type { JsonValue } from '../json/decoder.ts';
import { warnOfOthers, wordIn } from './fields.ts';
import type { MotionChannel, NamedCurve, NamedTarget } from './motion.ts';
import { readNumberKeys, readTurnKeys } from './read-keys.ts';
import { targetKinds } from './target-kinds.ts';

export const kept = 'the channel is not used; it is kept for saving';

const rules: readonly Extrapolation[] = ['constant', 'linear', 'cycle', 'cycle_offset', 'bounce'];
const known = ['target', 'extrapolate', 'keys'];

/** Reads a channel, or reports why it can't be used. */
export function readChannel(json: JsonValue): MotionChannel | undefined {
  const fields = json.record('a channel as an object');
  if (!fields) return undefined;
  warnOfOthers(fields, known);
  const place = fields.get('target');
  const target = place ? readTarget(place) : undefined;
  if (!place) json.fail('json', 'a channel with a "target"', 'none');
  if (!place || !target) return undefined;
  const curve = readCurve(json, fields, target);
  return curve && { target, curve, place, raw: json.value };
}

function readTarget(json: JsonValue): NamedTarget | undefined {
  const fields = json.record('a target as an object');
  if (!fields) return undefined;
  const kind = targetKinds.find((each) => each.matches(fields));
  if (kind) {
    warnOfOthers(fields, kind.fields);
    return kind.read(fields);
  }
  json.warn('unknown', 'a target that Sinew knows', [...fields.keys()].join(', ') || '{}', kept);
  return undefined;
}

function readCurve(
  json: JsonValue,
  fields: ReadonlyMap<string, JsonValue>,
  { rotation }: NamedTarget,
): NamedCurve | undefined {
  const extrapolate = readRules(fields.get('extrapolate'));
  const list = fields.get('keys');
  if (!list) json.fail('json', 'a channel with "keys"', 'none');
  if (!list || !extrapolate) return undefined;
  const [before, after] = extrapolate;
  if (rotation) {
    const keys = readTurnKeys(list);
    return keys && { of: 'rotation', curve: rotation, before, after, keys };
  }
  const keys = readNumberKeys(list);
  return keys && { of: 'number', before, after, keys };
}

function readRules(
  json: JsonValue | undefined,
): readonly [Extrapolation, Extrapolation] | undefined {
  if (!json) return ['constant', 'constant'];
  if (!Array.isArray(json.value) || json.value.length !== 2) {
    json.fail('json', '"extrapolate" with two words, for before and after the keys');
    return undefined;
  }
  const before = wordIn(json.member(0), rules);
  const after = wordIn(json.member(1), rules);
  return before && after && [before, after];
}
