import { defaultLimits } from '../../core/limits.ts';
import type { JsonValue } from '../../formats/json/decoder.ts';
import { numberWithin } from './codec.ts';
import { indexOfKey, keyAt } from '../../formats/json/keys.ts';

const weight = numberWithin(-defaultLimits.weight, defaultLimits.weight);

/** Returns the weights of morphs by name, without those that are 0. */
export function writeMorphWeights(
  names: readonly string[],
  weights: Float64Array,
): Record<string, unknown> {
  const written: [string, number][] = [];
  for (const [index, value] of weights.entries()) {
    if (!Object.is(value, 0)) written.push([keyAt(names, index), value]);
  }
  return Object.fromEntries(written);
}

export function readMorphWeights(json: JsonValue, names: readonly string[]): Float64Array {
  const weights = new Float64Array(names.length);
  for (const [key, member] of json.record('weights by morph') ?? []) {
    const index = indexOfKey(names, key);
    if (index < 0) member.failName('unknown', 'the name of a morph, or # and its index', key);
    else weights[index] = weight.read(member) ?? 0;
  }
  return weights;
}
