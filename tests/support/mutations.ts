import fc from 'fast-check';
import { bytesOf } from './files.ts';

type Mutation = (bytes: Uint8Array) => Uint8Array;

/** The bytes after one to five changes of any kind: bits, pieces, lines, numbers, or truncation. */
export function mutated(
  bytes: Uint8Array,
  oddNumbers: readonly string[],
): fc.Arbitrary<Uint8Array> {
  const mutation = fc.oneof(
    { weight: 2, arbitrary: flipped },
    { weight: 2, arbitrary: spliced },
    { weight: 2, arbitrary: copied },
    { weight: 3, arbitrary: linesMoved },
    { weight: 4, arbitrary: numberReplaced(oddNumbers) },
    { weight: 1, arbitrary: cut },
  );
  return fc
    .array(mutation, { minLength: 1, maxLength: 5 })
    .map((mutations) => mutations.reduce((changed, mutate) => mutate(changed), bytes));
}

const flipped = fc.tuple(fc.nat(), fc.nat(7)).map(
  ([at, bit]): Mutation =>
    (bytes) =>
      bytes.map((byte, i) => (i === at % bytes.length ? byte ^ (1 << bit) : byte)),
);

const spliced = fc.tuple(fc.nat(), fc.nat(8), fc.uint8Array({ maxLength: 8 })).map(
  ([at, removed, put]): Mutation =>
    (bytes) =>
      splice(bytes, at, removed, put),
);

/** Copies a piece and inserts it, or overwrites something else with it. */
const copied = fc
  .tuple(fc.nat(), fc.nat(60), fc.nat(), fc.boolean())
  .map(([from, length, to, over]): Mutation => (bytes) => {
    const start = from % (bytes.length + 1);
    const piece = bytes.slice(start, start + length);
    return splice(bytes, to, over ? piece.length : 0, piece);
  });

/** A binary file may be one line, which must not grow without limit. */
const largestLines = 20_000;

/** Removes a line, moves it, or repeats it. */
const linesMoved = fc
  .tuple(fc.nat(), fc.nat(), fc.nat(20), fc.boolean())
  .map(([from, to, times, keep]): Mutation => (bytes) => {
    const lines = textOfBytes(bytes).split('\n');
    const line = lines[from % lines.length]!;
    if (!keep) lines.splice(from % lines.length, 1);
    const fitting = Math.min(times, Math.floor(largestLines / (line.length + 1)));
    lines.splice(to % (lines.length + 1), 0, ...new Array<string>(fitting).fill(line));
    return bytesOfText(lines.join('\n'));
  });

function numberReplaced(oddNumbers: readonly string[]): fc.Arbitrary<Mutation> {
  return fc
    .tuple(fc.nat(), fc.constantFrom(...oddNumbers))
    .map(([which, put]): Mutation => (bytes) => {
      const text = textOfBytes(bytes);
      const numbers = [...text.matchAll(/[-+\d.eE]+/g)];
      if (numbers.length === 0) return bytes;
      const { index, 0: number } = numbers[which % numbers.length]!;
      const head = bytesOfText(text.slice(0, index));
      const tail = bytesOfText(text.slice(index + number.length));
      return joined(head, bytesOf(put), tail);
    });
}

const cut = fc.nat().map(
  (at): Mutation =>
    (bytes) =>
      bytes.slice(0, at % (bytes.length + 1)),
);

function splice(bytes: Uint8Array, at: number, removed: number, put: Uint8Array): Uint8Array {
  const start = at % (bytes.length + 1);
  return joined(bytes.slice(0, start), put, bytes.slice(start + removed));
}

function joined(...parts: readonly Uint8Array[]): Uint8Array {
  const bytes = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    bytes.set(part, at);
    at += part.length;
  }
  return bytes;
}

/** Converts each byte to a character, so that bytes that are not text are preserved. */
function textOfBytes(bytes: Uint8Array): string {
  return Array.from(bytes, (byte) => String.fromCharCode(byte)).join('');
}

function bytesOfText(text: string): Uint8Array {
  return Uint8Array.from(text, (character) => character.charCodeAt(0));
}
