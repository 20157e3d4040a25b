import type { DiagnosticLog } from '../../core/diagnostics.ts';
import { defaultLimits, type Limits } from '../../core/limits.ts';
import { decodeText } from './decode-text.ts';
import { carriageReturn, endOfLineEnd, isBlank, lineFeed } from './line-ends.ts';
import { reportEncoding, reportLength, reportOpenEnd } from './line-problems.ts';
import { readInteger, readNumber } from './read-number.ts';

const hash = 0x23;
const backslash = 0x5c;
const beyondAscii = 0x80;

/** Longer words are shown cut; no keyword is as long. */
const longestText = 256;

export interface LineOptions {
  /**
   * First words of lines to which a backslash at their end joins the next line. Of all other lines, and of
   * comments, it is a part: names are often paths of Windows.
   */
  readonly continued?: ReadonlySet<string>;
  readonly limits?: Limits;
}

/**
 * Walks over the lines of a text file and the tokens of a line, byte by byte and without strings.
 * Lines end with LF, CRLF, CR CR LF or a bare CR; `#` at the start of a token comments out the rest
 * of its line. Ends early, with an error, at a line past the limit.
 */
export class LineReader {
  readonly bytes: Uint8Array;
  readonly limits: Limits;
  /** One-based number of the current line, the first where several are joined. */
  line = 0;
  /** The current token's bytes, end exclusive. */
  tokenStart = 0;
  tokenEnd = 0;
  private lineStart = 0;
  private lineEnd = 0;
  /** Where the last of the lines that are joined starts. */
  private lastStart = 0;
  private nextLine = 1;
  private nextStart = 0;
  /** All bytes of the line, or-ed. */
  private bits = 0;
  private encodingReported = false;
  private readonly log: DiagnosticLog;
  private readonly continued: ReadonlySet<string>;
  /** Whether a backslash at the end of the current line joins the next to it. */
  private joins = false;

  constructor(bytes: Uint8Array, log: DiagnosticLog, options: LineOptions = {}) {
    this.bytes = bytes;
    this.log = log;
    this.continued = options.continued ?? new Set();
    this.limits = options.limits ?? defaultLimits;
  }

  /** Goes on to the next line; false at the end of the file. */
  next(): boolean {
    if (this.nextStart >= this.bytes.length) return false;
    this.line = this.nextLine;
    this.lineStart = this.nextStart;
    this.bits = 0;
    this.findLineEnd();
    this.joins = this.endsOpen() && this.isContinued();
    while (this.joins && this.endsOpen() && this.nextStart < this.bytes.length) this.findLineEnd();
    this.tokenEnd = this.lineStart;
    const bytes = this.bytes.subarray(this.lineStart, this.lineEnd);
    if (bytes.length > this.limits.lineLength) {
      reportLength(this.log, this.linePlace, bytes.length, this.limits.lineLength);
      this.nextStart = this.bytes.length;
      return false;
    }
    if (this.bits >= beyondAscii && !this.encodingReported) {
      this.encodingReported = reportEncoding(this.log, this.linePlace, bytes);
    }
    if (this.joins && this.endsOpen()) reportOpenEnd(this.log, this.linePlace);
    return true;
  }

  /** Goes on to the next token of the line; false at its end or at a comment. */
  token(): boolean {
    let at = this.tokenEnd;
    while (at < this.lineEnd && (isBlank(this.bytes[at]!) || this.isContinuation(at))) at++;
    this.tokenStart = at;
    if (at >= this.lineEnd || this.bytes[at] === hash) {
      this.tokenEnd = this.tokenStart;
      return false;
    }
    while (at < this.lineEnd && !isBlank(this.bytes[at]!) && !this.isContinuation(at)) at++;
    this.tokenEnd = at;
    return true;
  }

  /** Whether the token has more characters than a number may have. */
  get isTooLong(): boolean {
    return this.tokenEnd - this.tokenStart > this.limits.tokenLength;
  }

  /** The token as a number; NaN where it is none. */
  number(): number {
    return readNumber(this.bytes, this.tokenStart, this.tokenEnd, this.limits.tokenLength);
  }

  /** The token as a whole number; NaN where it is none. */
  integer(): number {
    return readInteger(this.bytes, this.tokenStart, this.tokenEnd, this.limits.tokenLength);
  }

  /** The token as text, cut where it is longer than any word. */
  text(): string {
    const end = Math.min(this.tokenEnd, this.tokenStart + longestText);
    return decodeText(this.bytes.subarray(this.tokenStart, end));
  }

  /** What follows the token on its line, trimmed, comments kept: names may hold blanks and `#`. */
  rest(): string {
    return decodeText(this.bytes.subarray(this.tokenEnd, this.lineEnd)).trim();
  }

  /** Whether the line is all comment. */
  isComment(): boolean {
    let at = this.lineStart;
    while (at < this.lineEnd && isBlank(this.bytes[at]!)) at++;
    return at < this.lineEnd && this.bytes[at] === hash;
  }

  /** How many tokens the line has; goes back to before the first. */
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
    if (!this.joins || this.bytes[at] !== backslash) return false;
    let after = at + 1;
    while (isSpace(this.bytes[after])) after++;
    const next = this.bytes[after];
    return next === undefined || next === lineFeed || next === carriageReturn;
  }

  /** Blanks behind the backslash change nothing: editors leave them. */
  private endsOpen(): boolean {
    let last = this.lineEnd - 1;
    while (last >= this.lineStart && isSpace(this.bytes[last])) last--;
    return last >= this.lineStart && this.bytes[last] === backslash && !this.hasComment();
  }

  /** Whether the last line has a comment; those before it, which were joined, had none. */
  private hasComment(): boolean {
    let follows = true;
    for (let at = this.lastStart; at < this.lineEnd; at++) {
      if (follows && this.bytes[at] === hash) return true;
      follows = isBlank(this.bytes[at]!);
    }
    return false;
  }

  /** Whether the line's first word is one that may be continued. */
  private isContinued(): boolean {
    let start = this.lineStart;
    while (start < this.lineEnd && isBlank(this.bytes[start]!)) start++;
    let end = start;
    while (end < this.lineEnd && !isBlank(this.bytes[end]!) && end - start < longestText) end++;
    return this.continued.has(decodeText(this.bytes.subarray(start, end)));
  }

  private findLineEnd(): void {
    const { bytes } = this;
    this.lastStart = this.nextStart;
    let at = this.nextStart;
    while (at < bytes.length && bytes[at] !== lineFeed && bytes[at] !== carriageReturn) {
      this.bits |= bytes[at]!;
      at++;
    }
    this.lineEnd = at;
    this.nextStart = endOfLineEnd(bytes, at);
    this.nextLine++;
  }
}

/** A blank within a line. */
function isSpace(byte: number | undefined): boolean {
  return byte === 0x20 || byte === 0x09;
}
