import { decodeText } from './decode-text.ts';
import { carriageReturn, endOfLineEnd, isBlank, lineFeed } from './line-ends.ts';
import { readInteger, readNumber } from './read-number.ts';

const quotationMark = 0x22;
const hash = 0x23;
const star = 0x2a;
const slash = 0x2f;
const openBrace = 0x7b;
const closeBrace = 0x7d;

/** Longer words are cut when they are converted to text. */
const longestText = 1024;

/** A position of a `TokenReader` to which it can return. */
export interface TokenMark {
  readonly line: number;
  readonly lineStart: number;
  readonly tokenStart: number;
  readonly tokenEnd: number;
}

/**
 * Scans the tokens of a text in which line breaks have no meaning, byte by byte, without making
 * strings. A token is a brace, or a run of anything except white space and braces, so `leg{` is two
 * tokens. Comments are skipped where a token could start: `//` and `#` to the end of the line, and
 * from `/*` to its end.
 */
export class TokenReader {
  readonly bytes: Uint8Array;
  /** One-based line of the current token. */
  line = 1;
  /** The current token's bytes, end exclusive; empty at the end of the file. */
  tokenStart = 0;
  tokenEnd = 0;
  /** The line of a comment that is never closed. */
  openComment: number | undefined;
  private lineStart = 0;

  constructor(bytes: Uint8Array) {
    this.bytes = bytes;
  }

  /** Goes to the next token; returns false at the end of the file. */
  next(): boolean {
    const { bytes } = this;
    let at = this.skipBlanks(this.tokenEnd);
    this.tokenStart = at;
    if (at < bytes.length && !isBrace(bytes[at]!)) {
      do at++;
      while (at < bytes.length && !isBlank(bytes[at]!) && !isBrace(bytes[at]!));
    } else if (at < bytes.length) at++;
    this.tokenEnd = at;
    return at > this.tokenStart;
  }

  /** Extends a token that begins with a quotation mark to the closing mark on the same line. */
  private endQuotation(): boolean {
    const { bytes } = this;
    if (bytes[this.tokenStart] !== quotationMark) return false;
    let at = this.tokenStart + 1;
    while (at < bytes.length && bytes[at] !== quotationMark && !isLineEnd(bytes[at]!)) at++;
    if (bytes[at] !== quotationMark) return false;
    this.tokenEnd = at + 1;
    return true;
  }

  /** The token as text; if it begins with a quotation mark, the text up to the next one. */
  unquoted(): string {
    return this.endQuotation() ? this.text().slice(1, -1) : this.text();
  }

  get atEnd(): boolean {
    return this.tokenStart === this.tokenEnd;
  }

  get isOpen(): boolean {
    return this.bytes[this.tokenStart] === openBrace && !this.atEnd;
  }

  get isClose(): boolean {
    return this.bytes[this.tokenStart] === closeBrace && !this.atEnd;
  }

  get isWord(): boolean {
    return !this.atEnd && !isBrace(this.bytes[this.tokenStart]!);
  }

  /** Whether the token starts like a number. */
  get looksNumeric(): boolean {
    return !this.atEnd && /^[+-]?\.?\d/.test(this.text().slice(0, 4));
  }

  /** The number of bytes of the token. */
  get length(): number {
    return this.tokenEnd - this.tokenStart;
  }

  /** The token as a number; NaN if it is not one, or if it is longer than this. */
  number(longest?: number): number {
    return readNumber(this.bytes, this.tokenStart, this.tokenEnd, longest);
  }

  /** The token as a whole number; NaN if it is not one, or if it is longer than this. */
  integer(longest?: number): number {
    return readInteger(this.bytes, this.tokenStart, this.tokenEnd, longest);
  }

  /** The token as text. */
  text(): string {
    const end = Math.min(this.tokenEnd, this.tokenStart + longestText);
    return decodeText(this.bytes.subarray(this.tokenStart, end));
  }

  /** The number of bytes after the token; no valid count can be larger. */
  get bytesLeft(): number {
    return this.bytes.length - this.tokenEnd;
  }

  /** Line, column and the line's text, for a diagnostic about the current token. */
  get place(): { line: number; column: number; source: string } {
    const { bytes, line, lineStart } = this;
    let end = lineStart;
    while (end < bytes.length && end < lineStart + 160 && !isLineEnd(bytes[end]!)) end++;
    const source = decodeText(bytes.subarray(lineStart, end));
    return { line, column: this.tokenStart - lineStart + 1, source };
  }

  mark(): TokenMark {
    const { line, lineStart, tokenStart, tokenEnd } = this;
    return { line, lineStart, tokenStart, tokenEnd };
  }

  /** Returns to the marked position. */
  back({ line, lineStart, tokenStart, tokenEnd }: TokenMark): void {
    this.line = line;
    this.lineStart = lineStart;
    this.tokenStart = tokenStart;
    this.tokenEnd = tokenEnd;
  }

  /** Goes on at a place that another reader has reached by way of line feeds only. */
  skipTo(at: number, line: number): void {
    if (line > this.line) this.lineStart = this.bytes.lastIndexOf(lineFeed, at - 1) + 1;
    this.line = line;
    this.tokenStart = at;
    this.tokenEnd = at;
  }

  private skipBlanks(start: number): number {
    const { bytes } = this;
    let at = start;
    while (at < bytes.length) {
      const byte = bytes[at]!;
      if (isLineEnd(byte)) at = this.startLine(at);
      else if (isBlank(byte)) at++;
      else if (byte === hash || (byte === slash && bytes[at + 1] === slash)) {
        while (at < bytes.length && !isLineEnd(bytes[at]!)) at++;
      } else if (byte === slash && bytes[at + 1] === star) at = this.skipComment(at);
      else break;
    }
    return at;
  }

  private skipComment(start: number): number {
    const { bytes, line } = this;
    let at = start + 2;
    while (at < bytes.length) {
      if (bytes[at] === star && bytes[at + 1] === slash) return at + 2;
      at = isLineEnd(bytes[at]!) ? this.startLine(at) : at + 1;
    }
    this.openComment = line;
    return at;
  }

  private startLine(lineEnd: number): number {
    this.lineStart = endOfLineEnd(this.bytes, lineEnd);
    this.line++;
    return this.lineStart;
  }
}

function isBrace(byte: number): boolean {
  return byte === openBrace || byte === closeBrace;
}

function isLineEnd(byte: number): boolean {
  return byte === lineFeed || byte === carriageReturn;
}
