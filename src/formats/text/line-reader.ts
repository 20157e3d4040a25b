import { decodeText } from './check-text.ts';
import { carriageReturn, endOfLineEnd, isBlank, lineFeed } from './line-ends.ts';
import { readInteger, readNumber } from './read-number.ts';

const hash = 0x23;
const backslash = 0x5c;

/**
 * Walks over the lines of a text file and the tokens of a line, byte by byte and without strings.
 * Lines end with LF, CRLF, CR CR LF or a bare CR; `#` at the start of a token comments out the rest
 * of its line. With `continuations`, a backslash at a line's end joins the next line to it.
 */
export class LineReader {
  readonly bytes: Uint8Array;
  /** One-based number of the current line, the first where several are joined. */
  line = 0;
  /** The current token's bytes, end exclusive. */
  tokenStart = 0;
  tokenEnd = 0;
  private lineStart = 0;
  private lineEnd = 0;
  private nextLine = 1;
  private nextStart = 0;
  private readonly continuations: boolean;

  constructor(bytes: Uint8Array, continuations = false) {
    this.bytes = bytes;
    this.continuations = continuations;
  }

  /** Goes on to the next line; false at the end of the file. */
  next(): boolean {
    if (this.nextStart >= this.bytes.length) return false;
    this.line = this.nextLine;
    this.lineStart = this.nextStart;
    let joined: boolean;
    do {
      this.findLineEnd();
      joined =
        this.continuations &&
        this.bytes[this.lineEnd - 1] === backslash &&
        this.nextStart < this.bytes.length;
    } while (joined);
    this.tokenEnd = this.lineStart;
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

  /** The token as a number; NaN where it is none. */
  number(): number {
    return readNumber(this.bytes, this.tokenStart, this.tokenEnd);
  }

  /** The token as a whole number; NaN where it is none. */
  integer(): number {
    return readInteger(this.bytes, this.tokenStart, this.tokenEnd);
  }

  /** The token as text. */
  text(): string {
    return decodeText(this.bytes.subarray(this.tokenStart, this.tokenEnd));
  }

  /** What follows the token on its line, trimmed, comments kept: names may hold blanks and `#`. */
  rest(): string {
    return decodeText(this.bytes.subarray(this.tokenEnd, this.lineEnd)).trim();
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
    if (!this.continuations || this.bytes[at] !== backslash) return false;
    const next = this.bytes[at + 1];
    return next === undefined || next === lineFeed || next === carriageReturn;
  }

  private findLineEnd(): void {
    const { bytes } = this;
    let at = this.nextStart;
    while (at < bytes.length && bytes[at] !== lineFeed && bytes[at] !== carriageReturn) at++;
    this.lineEnd = at;
    this.nextStart = endOfLineEnd(bytes, at);
    this.nextLine++;
  }
}
