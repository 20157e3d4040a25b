import type { KeyParts, Tangent } from '../../core/motion/clip-parts.ts';
import { largest, type Scanner } from './scanner.ts';
import { closeRows, endsEarly } from './sections.ts';

/** A limit that no real clip reaches. */
const mostKeys = 1_000_000;
const largestValue = 1e12;

/**
 * Reads `K { time value tangentIn tangentOut … }` and returns keys at increasing times, one per
 * time.
 */
export function readKeys(scanner: Scanner): KeyParts[] {
  const count = scanner.count('keys', 8, mostKeys);
  if (!scanner.sound()) return [];
  if (count === 0) tellNone(scanner);
  const opened = scanner.openIfAny();
  const keys: KeyParts[] = [];
  for (let index = 0; index < count; index++) {
    if (endsEarly(scanner, 'keys', count, index)) return [];
    const key = readKey(scanner);
    if (!key) return [];
    keys.push(key);
  }
  return closeRows(scanner, 'keys', count, opened) ? rising(keys, scanner) : [];
}

/** Reports a channel without keys. */
export function tellNone(scanner: Scanner): void {
  const effect = 'the channel is 0 at all times, as are further ones without';
  scanner.warnOnce('no keys', 'empty', 'at least one key', 'none', effect);
}

function readKey(scanner: Scanner): KeyParts | undefined {
  const time = scanner.number('the time of a key', largest.time);
  const value = scanner.sound() ? scanner.number('the value of a key', largestValue) : NaN;
  const tangentIn = scanner.sound() ? readTangent(scanner) : 0;
  const tangentOut = scanner.sound() ? readTangent(scanner) : 0;
  return scanner.sound() ? { time, value, tangentIn, tangentOut } : undefined;
}

const isRule = (word: string): word is 'flat' | 'linear' | 'smooth' =>
  word === 'flat' || word === 'linear' || word === 'smooth';

function readTangent(scanner: Scanner): Tangent {
  const word = scanner.keyword(isRule);
  if (isRule(word)) return word;
  const slope = scanner.reader.number(scanner.limits.tokenLength);
  if (Math.abs(slope) <= largestValue) return slope;
  scanner.fail('token', 'a tangent: flat, linear, smooth or a number');
  return 0;
}

/** Sorts keys by time; of several at the same time the last one counts. */
function rising(keys: readonly KeyParts[], scanner: Scanner): KeyParts[] {
  const isRising = keys.every((key, index) => index === 0 || keys[index - 1]!.time < key.time);
  if (isRising) return [...keys];
  const effect = 'keys are sorted; of several at one time the last counts';
  scanner.warnOnce('order', 'order', 'keys at rising times', 'others', effect);
  const sorted = keys.toSorted((a, b) => a.time - b.time);
  return sorted.filter((key, index) => sorted[index + 1]?.time !== key.time);
}
