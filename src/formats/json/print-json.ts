/** Texts of values that never change, empty before they are first printed. */
const texts = new WeakMap<object, string>();

/** Lets the text of a large value that never changes be kept with it, and printed again at once. */
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
  const text = printObject(value);
  if (kept === '') texts.set(value, text);
  return text;
}

function printObject(value: object): string {
  if (Array.isArray(value)) return `[${value.map(printJson).join(',')}]`;
  const members = Object.entries(value).map(
    ([key, member]) => `${JSON.stringify(key)}:${printJson(member)}`,
  );
  return `{${members.join(',')}}`;
}
