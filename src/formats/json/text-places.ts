import type { Place } from '../../core/diagnostics.ts';

const longestSource = 160;
const lineFeed = 0x0a;
const carriageReturn = 0x0d;

/**
 * Places in a text that was decoded from UTF-8. Goes on from where it last stood, so that the places of
 * many faults, asked for in their order, cost one walk over the text.
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

/** As `endOfLineEnd` of bytes: LF, CRLF and CR CR LF are one end each, other returns one apiece. */
function endOfLineEnd(text: string, start: number): number {
  for (const end of ['\r\r\n', '\r\n']) if (text.startsWith(end, start)) return start + end.length;
  return start + 1;
}

/** Bytes of a code unit in UTF-8; the two halves of a pair have two each. */
function byteCount(unit: number): number {
  if (unit < 0x80) return 1;
  const isHalf = unit >= 0xd800 && unit < 0xe000;
  return unit < 0x800 || isHalf ? 2 : 3;
}
