import type { DiagnosticLog } from '../../core/diagnostics.ts';
import { defaultLimits, type Limits } from '../../core/limits.ts';
import { decodeText } from './decode-text.ts';
import { carriageReturn, endOfLineEnd, isBlank, lineFeed } from './line-ends.ts';
import { reportEncoding, reportLength, reportOpenEnd } from './line-problems.ts';
import { readInteger, readNumber } from './read-number.ts';

const hash = 0x23;
const backslash = 0x5c;
const beyondAscii = 0x80;

/** Longer words are cut in messages; no keyword is that long. */
const longestText = 256;

export interface LineOptions {
  /**
   * First words of the lines that a backslash at their end continues on the next line. In all other
   * lines and in comments a backslash belongs to the text, because names are often paths on Windows.
   */
  readonly continued?: ReadonlySet<string>;
  readonly limits?: Limits;
}

/**
 * Scans the lines of a text file and the tokens of a line, byte by byte, without making strings.
 * Lines end with LF, CRLF, CR CR LF or a bare CR; `#` at the start of a token comments out the rest
 * of its line. Stops, with an error, at a line that exceeds the limit.
 */
export class LineReader {
  readonly bytes: Uint8Array;
  readonly limits: Limits;
  /** One-based number of the current line; the first one if several are joined. */
  line = 0;
  /** The current token's bytes, end exclusive. */
  tokenStart = 0;
  tokenEnd = 0;
  private lineStart = 0;
  private lineEnd = 0;
  /** Where the last of the lines that are joined starts. */
  private lastStart = 0;
  /** The number and the start of the next line; whoever has read some lines sets both. */
  nextLine = 1;
  nextStart = 0;
  /** All bytes of the line, combined by bitwise or. */
  private bits = 0;
  private encodingReported = false;
  private readonly log: DiagnosticLog;
  private readonly continued: ReadonlySet<string>;
  /** Whether a backslash at the end of the current line continues it on the next one. */
  private joins = false;

  constructor(bytes: Uint8Array, log: DiagnosticLog, options: LineOptions = {}) {
    this.bytes = bytes;
    this.log = log;
    this.continued = options.continued ?? new Set();
    this.limits = options.limits ?? defaultLimits;
  }

  /** Goes to the next line; returns false at the end of the file. */
  next(): boolean {
    if (this.nextStart >= this.bytes.length) return false;
    this.line = this.nextLine;
    this.lineStart = this.nextStart;
    this.bits = 0;
    this.findLineEnd();
    this.joins = this.endsOpen() && this.isContinued();
    while (this.joins && this.endsOpen() && this.nextStart < this.bytes.length) this.findLineEnd();
    this.tokenEnd = this.lineStart;
    const length = this.lineEnd - this.lineStart;
    if (length > this.limits.lineLength) {
      reportLength(this.log, this.linePlace, length, this.limits.lineLength);
      this.nextStart = this.bytes.length;
      return false;
    }
    if (this.bits >= beyondAscii && !this.encodingReported) {
      const bytes = this.bytes.subarray(this.lineStart, this.lineEnd);
      this.encodingReported = reportEncoding(this.log, this.linePlace, bytes);
    }
    if (this.joins && this.endsOpen()) reportOpenEnd(this.log, this.linePlace);
    return true;
  }

  /** Goes to the next token of the line; returns false at its end or at a comment. */
  token(): boolean {
    const { bytes, lineEnd, joins } = this;
    let at = this.tokenEnd;
    while (at < lineEnd && (isBlank(bytes[at]!) || (joins && this.isContinuation(at)))) at++;
    this.tokenStart = at;
    if (at >= lineEnd || bytes[at] === hash) {
      this.tokenEnd = at;
      return false;
    }
    while (at < lineEnd && !isBlank(bytes[at]!) && !(joins && this.isContinuation(at))) at++;
    this.tokenEnd = at;
    return true;
  }

  /** Whether the token has more characters than a number may have. */
  get isTooLong(): boolean {
    return this.tokenEnd - this.tokenStart > this.limits.tokenLength;
  }

  /** The token as a number; NaN if it is not one. */
  number(): number {
    return readNumber(this.bytes, this.tokenStart, this.tokenEnd, this.limits.tokenLength);
  }

  /** The token as a whole number; NaN if it is not one. */
  integer(): number {
    return readInteger(this.bytes, this.tokenStart, this.tokenEnd, this.limits.tokenLength);
  }

  /** The token as text, cut if it is longer than any keyword. */
  text(): string {
    const { bytes, tokenStart, tokenEnd } = this;
    // Nearly all words of large files are one letter.
    if (tokenEnd - tokenStart === 1 && bytes[tokenStart]! < beyondAscii) {
      return String.fromCharCode(bytes[tokenStart]!);
    }
    return decodeText(bytes.subarray(tokenStart, Math.min(tokenEnd, tokenStart + longestText)));
  }

  /**
   * The rest of the line after the token, trimmed, including comments, because names may contain
   * blanks and `#`.
   */
  rest(): string {
    return decodeText(this.bytes.subarray(this.tokenEnd, this.lineEnd)).trim();
  }

  /** Whether the line consists only of a comment. */
  isComment(): boolean {
    let at = this.lineStart;
    while (at < this.lineEnd && isBlank(this.bytes[at]!)) at++;
    return at < this.lineEnd && this.bytes[at] === hash;
  }

  /** Counts the tokens of the line, and returns to the start of the line. */
  countTokens(): number {
    this.tokenEnd = this.lineStart;
    let count = 0;
    while (this.token()) count++;
    this.tokenEnd = this.lineStart;
    return count;
  }

  /** Line, column and the line's text, for a diagnostic about the current token. */
  get place(): { line: number; column: number; source: string } {
    const { line } = this;
    return { line, column: this.tokenStart - this.lineStart + 1, source: this.source };
  }

  /** Line and text, for a diagnostic about the whole line. */
  get linePlace(): { line: number; source: string } {
    return { line: this.line, source: this.source };
  }

  private get source(): string {
    const end = Math.min(this.lineEnd, this.lineStart + 160);
    return decodeText(this.bytes.subarray(this.lineStart, end));
  }

  private isContinuation(at: number): boolean {
    if (this.bytes[at] !== backslash) return false;
    let after = at + 1;
    while (isSpace(this.bytes[after])) after++;
    const next = this.bytes[after];
    return next === undefined || next === lineFeed || next === carriageReturn;
  }

  /** Blanks after the backslash are ignored, because editors leave them there. */
  private endsOpen(): boolean {
    let last = this.lineEnd - 1;
    while (last >= this.lineStart && isSpace(this.bytes[last])) last--;
    return last >= this.lineStart && this.bytes[last] === backslash && !this.hasComment();
  }

  /** Whether the last of the joined lines has a comment; those before it had none. */
  private hasComment(): boolean {
    let follows = true;
    for (let at = this.lastStart; at < this.lineEnd; at++) {
      if (follows && this.bytes[at] === hash) return true;
      follows = isBlank(this.bytes[at]!);
    }
    return false;
  }

  /** Whether the line's first word is one that allows a continuation. */
  private isContinued(): boolean {
    let start = this.lineStart;
    while (start < this.lineEnd && isBlank(this.bytes[start]!)) start++;
    let end = start;
    while (end < this.lineEnd && !isBlank(this.bytes[end]!) && end - start < longestText) end++;
    return this.continued.has(decodeText(this.bytes.subarray(start, end)));
  }

  private findLineEnd(): void {
    const { bytes } = this;
    let { bits, nextStart: at } = this;
    this.lastStart = at;
    while (at < bytes.length && bytes[at] !== lineFeed && bytes[at] !== carriageReturn) {
      bits |= bytes[at]!;
      at++;
    }
    this.bits = bits;
    this.lineEnd = at;
    this.nextStart = endOfLineEnd(bytes, at);
    this.nextLine++;
  }
}

/** Whether a byte is a blank within a line. */
function isSpace(byte: number | undefined): boolean {
  return byte === 0x20 || byte === 0x09;
}
