/** Texts of values that never change, empty before they are first printed. */
const texts = new WeakMap<object, string>();

/**
 * Lets the text of a large value that never changes be kept with it, and printed again at once. No such
 * value contains another one.
 */
export function printedOnce<Value extends object>(value: Value): Value {
  texts.set(value, '');
  return value;
}

/**
 * Prints plain JSON as `JSON.stringify` does, except that it keeps the sign of -0, so that every
 * finite number is read again bit by bit.
 */
export function printJson(value: unknown): string {
  if (Object.is(value, -0)) return '-0';
  if (typeof value !== 'object' || value === null) return JSON.stringify(value);
  const kept = texts.get(value);
  if (kept) return kept;
  if (kept === undefined) return printObject(value);
  // The browser prints several times faster, where it prints the same.
  const text = hasNegativeZero(value) ? printObject(value) : JSON.stringify(value);
  texts.set(value, text);
  return text;
}

function hasNegativeZero(value: unknown): boolean {
  if (Array.isArray(value)) return value.some(hasNegativeZero);
  if (typeof value !== 'object' || value === null) return Object.is(value, -0);
  return Object.values(value).some(hasNegativeZero);
}

function printObject(value: object): string {
  if (Array.isArray(value)) return `[${value.map(printJson).join(',')}]`;
  const members = Object.entries(value).map(
    ([key, member]) => `${JSON.stringify(key)}:${printJson(member)}`,
  );
  return `{${members.join(',')}}`;
}
