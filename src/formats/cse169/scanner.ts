import type { DiagnosticCode, DiagnosticLog } from '../../core/diagnostics.ts';
import { defaultLimits, type Limits } from '../../core/limits.ts';
import { checkText } from '../text/check-text.ts';
import { PlainNumbers } from '../text/plain-numbers.ts';
import { reportTextEncoding } from '../text/report-encoding.ts';
import { TokenReader } from '../text/token-reader.ts';

type Area = 'skel' | 'skin' | 'morph' | 'anim' | 'rig';
type Kind<Code = DiagnosticCode> = Code extends `skin/${infer K}` ? K : never;

/** Limits on the magnitudes of angles (radians) and times (seconds); larger ones make no sense. */
export const largest = { angle: 1e6, time: 1e9 } as const;

/**
 * Shared by the five readers of CSE169: goes to the next token, reports unexpected ones, and skips
 * unknown parts. After the first error it reads nothing more.
 */
export class Scanner {
  readonly reader: TokenReader;
  readonly log: DiagnosticLog;
  readonly limits: Limits;
  private readonly plain: PlainNumbers;
  private readonly area: Area;
  private readonly effect: string;
  private readonly warned = new Set<string>();

  constructor(
    text: Uint8Array,
    log: DiagnosticLog,
    about: { readonly area: Area; readonly effect: string },
    limits: Limits = defaultLimits,
  ) {
    this.reader = new TokenReader(text);
    this.log = log;
    this.limits = limits;
    this.plain = new PlainNumbers(text, limits, true);
    this.area = about.area;
    this.effect = about.effect;
  }

  /** Whether reading can continue: no error has occurred. */
  sound(): boolean {
    return !this.log.failed;
  }

  /**
   * Lets `read` take plain numbers after the current token, as many as it wants, and goes on where it
   * leaves the cursor.
   */
  takePlain(read: (numbers: PlainNumbers) => void): void {
    const { reader, plain } = this;
    plain.at = reader.tokenEnd;
    plain.line = reader.line;
    read(plain);
    reader.skipTo(plain.at, plain.line);
  }

  /**
   * Goes to the next token and returns it as a keyword in lower case, or "" if it is not a word.
   */
  keyword(known: (word: string) => boolean): string {
    const { reader } = this;
    reader.next();
    if (!reader.isWord) return '';
    const text = reader.text();
    if (known(text)) return text;
    const lower = text.toLowerCase();
    if (!known(lower)) return text;
    const effect = 'it is read as that';
    this.warnOnce(`case ${lower}`, 'case', `"${lower}"`, text, effect);
    return lower;
  }

  /**
   * Reads the next token as a number of at most this magnitude; otherwise reports an error and
   * returns NaN.
   */
  number(what: string, most?: number): number {
    this.reader.next();
    return this.thisNumber(what, most);
  }

  /** Reads the current token as a number. */
  thisNumber(what: string, most: number = this.limits.coordinate): number {
    const { reader } = this;
    const value = reader.number(this.limits.tokenLength);
    if (Math.abs(value) <= most) return value;
    if (reader.length > this.limits.tokenLength) this.failLong(what);
    else if (Number.isNaN(value)) {
      const hint = /^[+-]?\d+,\d+$/.test(reader.text()) ? ' with a decimal point' : '';
      this.fail('number', `a number for ${what}${hint}`);
    } else this.fail('range', `${what} within ±${most.toExponential().replace('+', '')}`);
    return NaN;
  }

  triple(what: string, most?: number): [number, number, number] {
    const x = this.number(`${what} x`, most);
    const y = this.sound() ? this.number(`${what} y`, most) : NaN;
    return [x, y, this.sound() ? this.number(`${what} z`, most) : NaN];
  }

  /**
   * Reads the next token as a whole number from 0 to `most`; otherwise reports an error and returns
   * NaN.
   */
  index(what: string, most: number): number {
    this.reader.next();
    return this.thisIndex(what, most);
  }

  /** Reads the current token as a whole number. */
  thisIndex(what: string, most: number): number {
    const { reader } = this;
    const value = reader.integer(this.limits.tokenLength);
    if (value >= 0 && value <= most) return value;
    if (reader.length > this.limits.tokenLength) this.failLong(what);
    else if (value > most) this.fail('index', `${what} from 0 to ${most}`);
    else this.fail('integer', `a whole number for ${what}, 0 or more`);
    return NaN;
  }

  /**
   * Reads the next token as a count of items with a minimum size in bytes; the file must be large
   * enough for them.
   */
  count(what: string, bytesEach: number, most: number): number {
    const { reader } = this;
    reader.next();
    const value = reader.integer(this.limits.tokenLength);
    if (reader.length > this.limits.tokenLength) this.failLong(`how many ${what}`);
    else if (!(value >= 0)) this.fail('integer', `how many ${what}, a whole number`);
    else if (value * bytesEach > reader.bytesLeft + 1) {
      const possible = Math.floor(reader.bytesLeft / bytesEach);
      this.fail('count', `at most ${possible} ${what}, for the file has no room for more`);
    } else if (value > most) this.fail('limit', `at most ${most} ${what}`);
    else return value;
    return NaN;
  }

  /** The next token must be an opening brace. */
  open(): boolean {
    this.reader.next();
    if (!this.reader.isOpen) this.fail('token', '"{"');
    return this.sound();
  }

  /** Reads an opening brace if there is one, because some files leave it out. */
  openIfAny(): boolean {
    const mark = this.reader.mark();
    this.reader.next();
    if (this.reader.isOpen) return true;
    this.reader.back(mark);
    return false;
  }

  /** The next token must be a closing brace; if none was opened, it may be missing. */
  close(of: string, opened = true): boolean {
    const mark = this.reader.mark();
    this.reader.next();
    if (this.reader.isClose) return true;
    if (opened) this.fail('token', `"}" for ${of}`);
    else this.reader.back(mark);
    return this.sound();
  }

  /**
   * After an unknown word, skips the numbers that follow, or the block that follows with its
   * content, and reports it once per word.
   */
  skipUnknown(known: (word: string) => boolean): void {
    const { reader } = this;
    const word = reader.text();
    const effect = 'it is skipped, with its numbers or its block';
    this.warnOnce(`unknown ${word}`, 'unknown', 'a word of this format', word, effect);
    let mark = reader.mark();
    while (reader.next() && reader.looksNumeric) mark = reader.mark();
    if (reader.isWord && !known(reader.text().toLowerCase())) reader.next(); // perhaps the name of a block
    if (reader.isOpen) this.skipBlock();
    else reader.back(mark);
  }

  /** Skips to the brace that closes the last one that was read. */
  skipBlock(): void {
    const { reader } = this;
    const line = reader.line;
    for (let depth = 1; depth > 0;) {
      if (!reader.next()) {
        this.fail('end', `"}" for "{" of line ${line}`);
        return;
      }
      if (reader.isOpen) depth++;
      else if (reader.isClose) depth--;
    }
  }

  /** Reports content after the end of a file's only block, and skips it. */
  trailing(known: (word: string) => boolean, what: string): void {
    const { reader } = this;
    if (!reader.isWord) this.fail('token', what);
    else {
      this.warnOnce('trailing', 'trailing', what, reader.text(), 'it is skipped');
      this.warned.add(`unknown ${reader.text()}`);
      this.skipUnknown(known);
    }
  }

  /**
   * At the end of the file, reports a comment that was never closed and may have hidden the rest.
   */
  checkEnd(): void {
    if (this.reader.openComment !== undefined) this.fail('end', '"*/"');
  }

  /** Reports an error at the current token. */
  fail(kind: Kind, expected: string, found = this.found()): void {
    if (!this.sound()) return;
    const { area, effect } = this;
    const ended =
      this.reader.atEnd && (kind === 'token' || kind === 'number' || kind === 'integer');
    const code: DiagnosticCode = `${area}/${ended ? 'end' : kind}`;
    this.log.error({ code, ...this.reader.place, expected, found, effect });
  }

  /** Reports a warning at the current token. */
  warn(kind: Kind, expected: string, found: string, effect: string): void {
    this.log.warn({ code: `${this.area}/${kind}`, ...this.reader.place, expected, found, effect });
  }

  /** Reports a warning at the first occurrence of its kind. */
  warnOnce(key: string, kind: Kind, expected: string, found: string, effect: string): void {
    if (this.warned.has(key)) return;
    this.warned.add(key);
    this.warn(kind, expected, found, effect);
  }

  private failLong(what: string): void {
    this.fail('token', `a number of at most ${this.limits.tokenLength} characters for ${what}`);
  }

  private found(): string {
    const { reader } = this;
    if (!reader.atEnd) return reader.text();
    return reader.openComment === undefined
      ? 'the end of the file'
      : `a comment from line ${reader.openComment} without end`;
  }
}

/** Returns a scanner of a file's text, or reports that the file is not text and returns nothing. */
export function scan(
  file: string,
  bytes: Uint8Array,
  log: DiagnosticLog,
  about: { readonly area: Area; readonly effect: string },
  limits?: Limits,
): Scanner | undefined {
  const text = checkText(file, bytes, log);
  if (text) reportTextEncoding(log, text);
  return text && new Scanner(text, log, about, limits);
}
