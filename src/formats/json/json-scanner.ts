import type { DiagnosticKind } from '../../core/diagnostics.ts';

/** Thrown at any depth of the parser; it never leaves `parseJson`. */
export class JsonFault extends Error {
  readonly at: number;
  readonly kind: DiagnosticKind;
  readonly expected: string;
  readonly found: string;

  constructor(at: number, kind: DiagnosticKind, expected: string, found: string) {
    super(expected);
    this.at = at;
    this.kind = kind;
    this.expected = expected;
    this.found = found;
  }
}

const number = /^-?(0|[1-9]\d*)(\.\d+)?([eE][+-]?\d+)?$/;
const constants: ReadonlyMap<string, unknown> = new Map<string, unknown>([
  ['true', true],
  ['false', false],
  ['null', null],
]);
const escape = /\\(["\\/bfnrt]|u[\da-fA-F]{4})/y;
const wordCharacters = /[\w.+-]*/y;
const longestFound = 64;

/**
 * Scans the punctuation, strings and words of a JSON text, and throws a `JsonFault` at anything
 * else.
 */
export class JsonScanner {
  /** Offset of the next code unit. */
  at = 0;
  readonly text: string;

  constructor(text: string) {
    this.text = text;
  }

  /** Reads a string; its opening quote comes next. */
  string(): string {
    let text = '';
    this.at++;
    for (;;) {
      const start = this.at;
      while (isPlain(this.text.charCodeAt(this.at))) this.at++;
      text += this.text.slice(start, this.at);
      if (this.text[this.at] === '\\') text += this.escape();
      else if (this.text[this.at] === '"') break;
      else this.fail('a quote at the end of the string');
    }
    this.at++;
    return text;
  }

  /** Reads a number or a constant. */
  word(): unknown {
    const word = this.wordAt();
    const isNumber = number.test(word);
    if (!isNumber && !constants.has(word))
      this.fail(/^[-+.]?\d/.test(word) ? 'a number' : 'a value');
    this.at += word.length;
    return isNumber ? Number(word) : constants.get(word);
  }

  /** Skips blanks and returns whether the mark comes next; if so, goes past it. */
  takes(mark: string): boolean {
    const isThere = this.text[this.skipBlanks()] === mark;
    if (isThere) this.at++;
    return isThere;
  }

  /** @returns the offset after the blanks */
  skipBlanks(): number {
    while (' \t\r\n'.includes(this.text[this.at] ?? 'none')) this.at++;
    return this.at;
  }

  fail(expected: string, kind: DiagnosticKind = 'json'): never {
    throw new JsonFault(this.at, kind, expected, this.found());
  }

  private escape(): string {
    escape.lastIndex = this.at;
    const [found] = escape.exec(this.text) ?? [];
    if (found === undefined) this.fail('\\ and one of " \\ / b f n r t, or u and four digits');
    this.at += found.length;
    return JSON.parse(`"${found}"`) as string;
  }

  /**
   * The letters, digits and signs from here on: a number or a constant, possibly a misspelled one.
   */
  private wordAt(): string {
    wordCharacters.lastIndex = this.at;
    return wordCharacters.exec(this.text)![0];
  }

  private found(): string {
    const point = this.text.codePointAt(this.at);
    if (point === undefined) return 'the end of the text';
    const character = String.fromCodePoint(point);
    if (/[\r\n]/.test(character)) return 'the end of the line';
    if (character === '\\') return this.text.slice(this.at, this.at + 2);
    return this.wordAt().slice(0, longestFound) || character;
  }
}

/** Whether a code unit in a string represents itself. */
function isPlain(unit: number): boolean {
  return unit >= 0x20 && unit !== 0x22 && unit !== 0x5c;
}
