import type { JsonValue } from '../json/decoder.ts';

/** Longer than any name that a file may have. */
const longestName = 4096;

/** Reads the name of a joint or a morph, or `#` and its index. */
export function nameIn(json: JsonValue, of: string): string | undefined {
  const name = json.text(`the name of a ${of}, or # and its index`);
  if (name === undefined || name.length <= longestName) return name;
  json.fail('limit', `a name of at most ${longestName} characters`, `${name.length}`);
  return undefined;
}

/** Reads one of several words. */
export function wordIn<Word extends string>(
  json: JsonValue,
  words: readonly Word[],
): Word | undefined {
  const { value } = json;
  const found = words.find((word) => word === value);
  if (found === undefined) json.fail('token', `one of ${words.join(', ')}`);
  return found;
}

/** Reads a number whose magnitude is at most `largest`. */
export function numberIn(json: JsonValue, largest: number, expected: string): number | undefined {
  const { value } = json;
  if (typeof value !== 'number') json.fail('json', expected);
  else if (Math.abs(value) <= largest) return value;
  else json.fail('range', `${expected} within ±${largest.toExponential().replace('+', '')}`);
  return undefined;
}

export function isWithin(value: unknown, largest: number): value is number {
  return typeof value === 'number' && Math.abs(value) <= largest;
}

/** Reports the fields of an object that its form does not have. */
export function warnOfOthers(
  fields: ReadonlyMap<string, JsonValue>,
  known: readonly string[],
): void {
  for (const [name, field] of fields) {
    if (known.includes(name)) continue;
    field.warn('unknown', `one of ${known.join(', ')}`, name, 'it is left out');
  }
}
