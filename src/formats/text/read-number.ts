import { defaultLimits } from '../../core/limits.ts';

/**
 * Returns the double nearest to a decimal number, `[+-] digits [. digits] [e [+-] digits]`. Returns
 * NaN if the bytes are anything else (such as `Infinity`, `0x10`, `1e` or `1.2.3`) or more than
 * `longest`. Beyond the range of a double it is ±Infinity.
 *
 * It rounds correctly and makes no string in nearly all cases: up to 15 significant digits and a
 * power of ten up to 22 are both exact doubles, so that one multiplication or division rounds once
 * (Clinger 1990, "How to read floating point numbers accurately"). Other numbers go to `Number`.
 */
export function readNumber(
  bytes: Uint8Array,
  start: number,
  end: number,
  longest = defaultLimits.tokenLength,
): number {
  if (end - start > longest) return NaN;
  let at = start;
  const negative = bytes[at] === minus;
  if (negative || bytes[at] === plus) at++;

  let mantissa = 0;
  let significant = 0;
  let digitCount = 0;
  let power = 0;
  let afterPoint = false;
  for (; at < end; at++) {
    const byte = bytes[at]!;
    if (byte === point && !afterPoint) {
      afterPoint = true;
      continue;
    }
    const digit = byte - zero;
    if (digit < 0 || digit > 9) break;
    digitCount++;
    if (afterPoint) power--;
    mantissa = mantissa * 10 + digit;
    if (mantissa > 0) significant++;
  }
  if (digitCount === 0) return NaN;

  if (at < end) {
    if ((bytes[at]! | lowerCase) !== letterE) return NaN;
    at++;
    const exponentNegative = bytes[at] === minus;
    if (exponentNegative || bytes[at] === plus) at++;
    if (at >= end) return NaN;
    let exponent = 0;
    for (; at < end; at++) {
      const digit = bytes[at]! - zero;
      if (digit < 0 || digit > 9) return NaN;
      exponent = Math.min(exponent * 10 + digit, 100_000);
    }
    power += exponentNegative ? -exponent : exponent;
  }

  if (significant > 15 || power < -22 || power > 22) {
    return Number(String.fromCharCode(...bytes.subarray(start, end)));
  }
  const value = power < 0 ? mantissa / powersOfTen[-power]! : mantissa * powersOfTen[power]!;
  return negative ? -value : value;
}

/** Returns the decimal whole number, with an optional sign, that the bytes contain, or NaN. */
export function readInteger(
  bytes: Uint8Array,
  start: number,
  end: number,
  longest = defaultLimits.tokenLength,
): number {
  if (end - start > longest) return NaN;
  let at = start;
  const negative = bytes[at] === minus;
  if (negative || bytes[at] === plus) at++;
  if (at >= end) return NaN;
  let value = 0;
  for (; at < end; at++) {
    const digit = bytes[at]! - zero;
    if (digit < 0 || digit > 9) return NaN;
    value = value * 10 + digit;
  }
  return negative ? -value : value;
}

const plus = 0x2b;
const minus = 0x2d;
const point = 0x2e;
const zero = 0x30;
const letterE = 0x65;
const lowerCase = 0x20;
/** The powers of ten that are exact doubles. */
export const powersOfTen: readonly number[] = Array.from({ length: 23 }, (_, power) =>
  Number(`1e${power}`),
);
