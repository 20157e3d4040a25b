/**
 * The value of a JSON text whose objects have each name once, by the browser's own parser, which takes
 * a tenth of the time of one that remembers places.
 *
 * @param depth how many values may stand in one another
 * @returns nothing if the text is not JSON, nests more deeply, or has a name twice
 */
export function plainJson(text: string, depth: number): { readonly value: unknown } | undefined {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    return undefined;
  }
  // A name that an object has twice is one name of the value, but two colons of the text.
  return namesIn(value, depth) === colonsIn(text) ? { value } : undefined;
}

/** How many names all objects have; NaN if they nest too deeply. */
function namesIn(value: unknown, depth: number): number {
  if (typeof value !== 'object' || value === null) return 0;
  if (depth === 0) return NaN;
  let count = 0;
  if (Array.isArray(value)) {
    for (const each of value as readonly unknown[]) {
      if (typeof each === 'object') count += namesIn(each, depth - 1);
    }
    return count;
  }
  for (const each of Object.values(value)) count += 1 + namesIn(each, depth - 1);
  return count;
}

/** How many colons stand outside the strings of a JSON text. */
function colonsIn(text: string): number {
  let count = 0;
  for (let at = 0; at < text.length; at++) {
    const unit = text.charCodeAt(at);
    if (unit === colon) count++;
    if (unit !== quote) continue;
    for (at++; text.charCodeAt(at) !== quote; at++) if (text.charCodeAt(at) === backslash) at++;
  }
  return count;
}

const [colon, quote, backslash] = [0x3a, 0x22, 0x5c];
