import type { JsonValue } from '../../formats/json/decoder.ts';

/** How one kind of value is saved in JSON and read again. */
export interface Codec<T> {
  /** Returns plain JSON, from which `read` makes the same value, bit by bit. */
  write(value: T): unknown;
  /** Returns nothing if the JSON has another form, which it reports with its path. */
  read(json: JsonValue): T | undefined;
}

/** A codec of values that are JSON already. */
function plain<T>(isValid: (value: unknown) => boolean, expected: string): Codec<T> {
  return {
    write: (value) => value,
    read(json) {
      if (isValid(json.value)) return json.value as T;
      json.fail('json', expected);
      return undefined;
    },
  };
}

export const flag = plain<boolean>((value) => typeof value === 'boolean', 'true or false');

export function numberWithin(least: number, most: number): Codec<number> {
  const expected = `a number from ${least} to ${most}`;
  return plain((value) => Number.isFinite(value) && isWithin(value as number), expected);

  function isWithin(value: number): boolean {
    return value >= least && value <= most;
  }
}

/** An index of a list, which may turn out to be shorter. */
export const index = plain<number>(
  (value) => Number.isSafeInteger(value) && (value as number) >= 0,
  'a whole number from 0',
);

/** How many there are of something. */
export const countFrom1 = plain<number>(
  (value) => Number.isSafeInteger(value) && (value as number) >= 1,
  'a whole number from 1',
);

/** In UTF-16 units; longer than the name of any file. */
const longestText = 4096;

export const text = plain<string>(
  (value) => typeof value === 'string' && value.length <= longestText,
  `a text of at most ${longestText} characters`,
);

export function textLike(pattern: RegExp, expected: string): Codec<string> {
  return plain((value) => typeof value === 'string' && pattern.test(value), expected);
}

/** #rrggbb, in the display's encoding. */
export const color = textLike(/^#[\da-f]{6}$/i, 'a color as "#rrggbb"');

export function oneOf<T extends string>(values: readonly T[]): Codec<T> {
  const expected = `one of ${values.map((value) => `"${value}"`).join(', ')}`;
  return plain((value) => values.includes(value as T), expected);
}

export function orNull<T>(codec: Codec<T>): Codec<T | null> {
  return {
    write: (value) => (value === null ? null : codec.write(value)),
    read: (json) => (json.value === null ? null : codec.read(json)),
  };
}

/** A fixed count of numbers. */
export function numbers<T extends readonly number[]>(count: T['length'], most: number): Codec<T> {
  const expected = `${count} numbers from ${-most} to ${most}`;
  return {
    write: (value) => value,
    read(json) {
      const read = json.numbers([count], expected);
      const wrong = read?.findIndex((value) => Math.abs(value) > most) ?? -1;
      if (wrong < 0) return read as T | undefined;
      json.member(wrong).fail('range', expected);
      return undefined;
    },
  };
}

/** The number of parameters of all methods is far below this. */
const mostNames = 100;

/** Numbers by names; it is read without those that are wrong. */
export const numbersByName: Codec<Readonly<Record<string, number>>> = {
  write: (values) => values,
  read(json) {
    const members = json.record(`an object of at most ${mostNames} numbers`);
    if (!members) return undefined;
    const read = [...members].slice(0, mostNames).flatMap(([name, member]) => {
      const value = numberWithin(-1e6, 1e6).read(member);
      return value === undefined ? [] : [[name, value] as const];
    });
    return Object.fromEntries(read);
  },
};

/** A list; it is read without those of its items that are wrong. */
export function listOf<T>(codec: Codec<T>, longest: number): Codec<readonly T[]> {
  return {
    write: (values) => values.map((value) => codec.write(value)),
    read(json) {
      const items = json.list(longest, `a list of at most ${longest}`);
      return items?.flatMap((item) => {
        const read = codec.read(item);
        return read === undefined ? [] : [read];
      });
    },
  };
}

/** The values of a codec that are valid. */
export function checked<T>(
  codec: Codec<T>,
  isValid: (value: T) => boolean,
  expected: string,
): Codec<T> {
  return {
    write: (value) => codec.write(value),
    read(json) {
      const read = codec.read(json);
      if (read === undefined || isValid(read)) return read;
      json.fail('range', expected);
      return undefined;
    },
  };
}
