import type { Place } from '../../core/diagnostics.ts';

const longestSource = 160;
const lineFeed = 0x0a;
const carriageReturn = 0x0d;

/**
 * Converts offsets in a text that was decoded from UTF-8 to lines and columns. It continues from
 * its last position, so that increasing offsets need only one pass over the text.
 */
export class TextPlaces {
  private readonly text: string;
  private at = 0;
  private line = 1;
  private lineStart = 0;
  private column = 1;

  constructor(text: string) {
    this.text = text;
  }

  /** @param offset in code units, not within a line end */
  place(offset: number): Place {
    if (offset < this.at) [this.at, this.line, this.lineStart, this.column] = [0, 1, 0, 1];
    while (this.at < offset) this.step();
    const { line, column, lineStart, text } = this;
    const [source] = text.slice(lineStart, lineStart + longestSource).split(/[\r\n]/, 1);
    return { line, column, source: source! };
  }

  private step(): void {
    const unit = this.text.charCodeAt(this.at);
    if (unit === lineFeed || unit === carriageReturn) {
      this.at = endOfLineEnd(this.text, this.at);
      this.lineStart = this.at;
      this.line++;
      this.column = 1;
    } else {
      this.at++;
      this.column += byteCount(unit);
    }
  }
}

/**
 * Like `endOfLineEnd` of bytes: LF, CRLF and CR CR LF are one line end each, other carriage returns
 * one each.
 */
function endOfLineEnd(text: string, start: number): number {
  for (const end of ['\r\r\n', '\r\n']) if (text.startsWith(end, start)) return start + end.length;
  return start + 1;
}

/** Bytes of a code unit in UTF-8; each half of a surrogate pair counts as two. */
function byteCount(unit: number): number {
  if (unit < 0x80) return 1;
  const isHalf = unit >= 0xd800 && unit < 0xe000;
  return unit < 0x800 || isHalf ? 2 : 3;
}
