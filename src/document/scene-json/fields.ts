import { sameValue } from '../../core/same-value.ts';
import type { JsonValue } from '../../formats/json/decoder.ts';
import type { Codec } from './codec.ts';

/** A codec for each field of a value: a new field of its type is not compiled without its row. */
export type Codecs<T> = { readonly [Key in keyof T]-?: Codec<T[Key]> };

/** Writes the fields that differ from their defaults. */
export function writeFields<T extends object>(
  codecs: Codecs<T>,
  value: T,
  defaults: Partial<T> = {},
): Record<string, unknown> {
  const written: Record<string, unknown> = {};
  for (const key of keysOf(codecs)) {
    if (key in defaults && sameValue(value[key], defaults[key])) continue;
    written[key] = codecs[key].write(value[key]);
  }
  return written;
}

/**
 * Reads the fields that are there. A wrong field is reported and left out. So is one that is not
 * known, with a warning, because a newer Sinew may have written it.
 *
 * @param others fields that the caller reads itself
 */
export function readFields<T extends object>(
  codecs: Codecs<T>,
  json: JsonValue,
  others: readonly string[] = [],
): Partial<T> | undefined {
  const members = json.record('an object');
  if (!members) return undefined;
  const keys: readonly string[] = keysOf(codecs);
  const read: Partial<T> = {};
  for (const [key, member] of members) {
    if (others.includes(key)) continue;
    if (!keys.includes(key)) {
      const known = [...others, ...keys].join(', ');
      member.warn('unknown', `one of ${known}`, key, 'it is left out');
      continue;
    }
    const value = codecs[key as keyof T].read(member);
    if (value !== undefined) read[key as keyof T] = value;
  }
  return read;
}

/** A codec of an object whose fields have defaults. */
export function fields<T extends object>(defaults: T, codecs: Codecs<T>): Codec<T> {
  return {
    write: (value) => writeFields(codecs, value, defaults),
    read(json) {
      const read = readFields(codecs, json);
      return read && { ...defaults, ...read };
    },
  };
}

function keysOf<T extends object>(codecs: Codecs<T>): readonly (keyof T & string)[] {
  return Object.keys(codecs) as (keyof T & string)[];
}
