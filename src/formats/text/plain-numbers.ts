import type { Limits } from '../../core/limits.ts';
import { carriageReturn, lineFeed } from './line-ends.ts';
import { powersOfTen, readNumber } from './read-number.ts';

const tab = 0x09;
const space = 0x20;
const plus = 0x2b;
const minus = 0x2d;
const point = 0x2e;
const zero = 0x30;
const letterE = 0x65;
const closeBrace = 0x7d;
const lowerCase = 0x20;

/** So many digits always fit a 32-bit integer. */
const mostDigits = 9;

/**
 * Reads the plain numbers that nearly all of a large file consists of, with one cursor over its
 * bytes. It makes neither strings nor objects and reports nothing: it stops before anything else
 * (other tokens, comments, odd blanks), where a careful reader goes on. The last line is left to the
 * careful reader if it has no line end.
 */
export class PlainNumbers {
  /** The cursor: the next token is looked for from here on. */
  at = 0;
  /** One-based number of the cursor's line, if line ends are blanks. */
  line = 1;
  /** Bit i says whether number i of the last `numbers` was written with a point or an exponent. */
  unwhole = 0;
  readonly bytes: Uint8Array;
  /** The last line feed; what starts before it ends before it, so that no loop leaves the file. */
  readonly end: number;
  readonly limits: Limits;
  private readonly crossesLines: boolean;

  /** @param crossesLines whether line ends are blanks, and braces end a number */
  constructor(bytes: Uint8Array, limits: Limits, crossesLines: boolean) {
    this.bytes = bytes;
    this.end = bytes.lastIndexOf(lineFeed);
    this.limits = limits;
    this.crossesLines = crossesLines;
  }

  /**
   * Reads `most` numbers into `values`, or fewer if something else comes, and returns how many. Each
   * is the double that `readNumber` returns. All state is in local variables, because this loop
   * takes most of the time in which a file is read.
   */
  numbers(values: Float64Array, most: number): number {
    const { bytes, end, crossesLines } = this;
    const longest = this.limits.tokenLength;
    let { at, line } = this;
    let count = 0;
    let unwhole = 0;
    for (; count < most; count++) {
      let start = at;
      let lines = line;
      let byte = bytes[start]!;
      while (byte <= space && start < end) {
        if (byte !== space && byte !== tab) {
          if (!crossesLines) break;
          if (byte === lineFeed) lines++;
          else if (byte !== carriageReturn || bytes[start + 1] !== lineFeed) break;
        }
        byte = bytes[++start]!;
      }
      if (start >= end) break;
      // Most weights are zero.
      if (byte === zero && bytes[start + 1] === space) {
        values[count] = 0;
        at = start + 1;
        line = lines;
        continue;
      }

      let next = start;
      const isNegative = byte === minus;
      if (isNegative || byte === plus) byte = bytes[++next]!;
      const firstDigit = next;
      let whole = 0;
      let digit = byte - zero;
      while (digit >= 0 && digit <= 9) {
        whole = (whole * 10 + digit) | 0;
        byte = bytes[++next]!;
        digit = byte - zero;
      }
      const wholeDigits = next - firstDigit;
      let fraction = 0;
      let fractionDigits = 0;
      if (byte === point) {
        unwhole |= 1 << count;
        const afterPoint = ++next;
        byte = bytes[next]!;
        digit = byte - zero;
        while (digit >= 0 && digit <= 9) {
          fraction = (fraction * 10 + digit) | 0;
          byte = bytes[++next]!;
          digit = byte - zero;
        }
        fractionDigits = next - afterPoint;
      }
      let hasExponent = false;
      if ((byte | lowerCase) === letterE) {
        hasExponent = true;
        unwhole |= 1 << count;
        next = endOfExponent(bytes, next);
        byte = bytes[next]!;
      }
      const isToken = wholeDigits + fractionDigits > 0 && next - start <= longest;
      if (!endsNumber(byte, crossesLines) || !isToken) break;

      const isShort = wholeDigits <= mostDigits && fractionDigits <= mostDigits && !hasExponent;
      if (!isShort) values[count] = readNumber(bytes, start, next, longest);
      else if (fractionDigits === 0) values[count] = isNegative ? -whole : whole;
      else {
        const scale = powersOfTen[fractionDigits]!;
        const mantissa = whole * scale + fraction;
        if (mantissa <= Number.MAX_SAFE_INTEGER)
          values[count] = (isNegative ? -mantissa : mantissa) / scale;
        else values[count] = readNumber(bytes, start, next, longest);
      }
      at = next;
      line = lines;
    }
    this.at = at;
    this.line = line;
    this.unwhole = unwhole;
    return count;
  }

  /**
   * Reads `most` whole numbers from 0 to 999,999,999 into `values`, or fewer if something else comes,
   * and returns how many.
   */
  indices(values: Int32Array, most: number): number {
    const { bytes, end, crossesLines } = this;
    let { at, line } = this;
    let count = 0;
    for (; count < most; count++) {
      let start = at;
      let lines = line;
      let byte = bytes[start]!;
      while (byte <= space && start < end) {
        if (byte !== space && byte !== tab) {
          if (!crossesLines) break;
          if (byte === lineFeed) lines++;
          else if (byte !== carriageReturn || bytes[start + 1] !== lineFeed) break;
        }
        byte = bytes[++start]!;
      }
      if (start >= end) break;

      let next = start;
      let value = 0;
      let digit = byte - zero;
      while (digit >= 0 && digit <= 9) {
        value = (value * 10 + digit) | 0;
        byte = bytes[++next]!;
        digit = byte - zero;
      }
      const isToken = next > start && next - start <= mostDigits;
      if (!endsNumber(byte, crossesLines) || !isToken) break;
      values[count] = value;
      at = next;
      line = lines;
    }
    this.at = at;
    this.line = line;
    return count;
  }

  /** Goes to the next byte that is not blank, and returns it. */
  skipBlanks(): number {
    const { bytes, end, crossesLines } = this;
    let { at } = this;
    let byte = bytes[at]!;
    while (byte <= space && at < end) {
      if (byte === lineFeed && crossesLines) this.line++;
      else if (!isPlainBlank(bytes, at, byte, crossesLines)) break;
      byte = bytes[++at]!;
    }
    this.at = at;
    return byte;
  }

  /**
   * Goes to the next line if nothing but blanks is left of this one. Returns false otherwise, and if
   * the line is too long.
   */
  endLine(lineStart: number): boolean {
    const byte = this.skipBlanks();
    const lineEnd = this.at;
    const last = byte === carriageReturn ? lineEnd + 1 : lineEnd;
    if (this.bytes[last] !== lineFeed || lineEnd - lineStart > this.limits.lineLength) return false;
    this.at = last + 1;
    return true;
  }
}

/** A carriage return is plain only before a line feed, because others end lines too. */
function isPlainBlank(bytes: Uint8Array, at: number, byte: number, crossesLines: boolean): boolean {
  if (byte === space || byte === tab) return true;
  return crossesLines && byte === carriageReturn && bytes[at + 1] === lineFeed;
}

function endsNumber(byte: number, crossesLines: boolean): boolean {
  if (byte === space || byte === lineFeed || byte === carriageReturn || byte === tab) return true;
  return crossesLines && byte === closeBrace;
}

/** Returns where the exponent at `start` ends, or `start` if it has no digits. */
function endOfExponent(bytes: Uint8Array, start: number): number {
  const sign = bytes[start + 1];
  const first = sign === minus || sign === plus ? start + 2 : start + 1;
  let at = first;
  while (bytes[at]! >= zero && bytes[at]! <= zero + 9) at++;
  return at === first ? start : at;
}
