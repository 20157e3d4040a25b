/**
 * What a reader says about a bad file: a value with place, found, expected and effect, never an
 * exception. Codes are closed, so that a test and a translation can name them.
 */
export type Severity = 'error' | 'warning';

export type DiagnosticCode = `${DiagnosticArea}/${DiagnosticKind}`;

export type DiagnosticArea =
  | 'file'
  | 'skel'
  | 'obj'
  | 'attach'
  | 'skin'
  | 'morph'
  | 'anim'
  | 'rig'
  | 'pmd'
  | 'pose'
  | 'character'
  | 'image';

export type DiagnosticKind =
  | 'archive' // a zip that can't be unpacked, or lies within another
  | 'binary' // text expected, other bytes found
  | 'box' // corners in the wrong order
  | 'case' // a word in other letters than the format's
  | 'coincident' // joints that stand on one point
  | 'continuation' // a line to be continued by one that is not there
  | 'character' // looks like a blank or a minus sign, and is none
  | 'count' // two numbers of things that must agree
  | 'cycle' // joints that are their own ancestors
  | 'degrees' // angles that look like degrees
  | 'depth' // nested deeper than Sinew takes
  | 'duplicate' // given twice
  | 'degenerate' // triangles without area
  | 'empty' // nothing of what the file is for
  | 'encoding' // not UTF-8
  | 'end' // the file ends within something
  | 'face' // a face that is none
  | 'field-count' // too few or too many values on a line
  | 'html' // a web page in place of the file
  | 'ignored' // read and left out on purpose
  | 'index' // refers to something that is not there
  | 'integer' // a whole number expected
  | 'json' // not JSON, or not of the shape
  | 'limit' // larger than Sinew takes
  | 'limits' // of a joint, in the wrong order
  | 'lost' // has no place in the format that is written
  | 'magic' // a file of another kind, by its first bytes
  | 'matrix' // not of the shape
  | 'mirrored' // turns a right hand into a left one
  | 'missing' // a part of the character is not there
  | 'more' // further diagnostics left out
  | 'name' // none, or one that others have
  | 'normal' // none, or without a length
  | 'number' // a number expected
  | 'order' // times that do not rise
  | 'pairing' // files joined by guess
  | 'parent' // a parent that is no joint
  | 'pointer' // stands for a file that is elsewhere
  | 'range' // a number past what can be computed with, or past a joint's limits
  | 'rich-text' // written by a word processor
  | 'root' // no root, several, or not the first
  | 'section' // a part of the file that is not there
  | 'singular' // without an inverse
  | 'token' // another word expected
  | 'trailing' // after the end of what the file is for
  | 'truncated' // fewer bytes than the file has
  | 'unknown' // nothing here reads it
  | 'unknown-joint' // a joint name that no joint has, or that several have
  | 'unreadable' // there, but the browser does not hand it out
  | 'unwritable' // a place where no file can be put
  | 'uv' // texture coordinates that do not fit
  | 'version' // of the format, one that Sinew does not know
  | 'weight-negative'
  | 'weight-sum'
  | 'weight-zero';

/** Where in a file; nothing of it where the whole file is meant. */
export interface Place {
  /** One-based. */
  readonly line?: number;
  /** One-based, in bytes of the line; absent where the whole line is meant. */
  readonly column?: number;
  /** Of a binary file: bytes before the place. */
  readonly offset?: number;
  /** The line itself, shortened, for the Problems panel. */
  readonly source?: string;
  /** Of JSON: which of its values, as `joints."Left elbow"[1]`. */
  readonly path?: string;
}

export interface Diagnostic extends Place {
  readonly severity: Severity;
  readonly code: DiagnosticCode;
  readonly file: string;
  readonly expected: string;
  readonly found: string;
  /** What became of it, for the user: "the file is not used", "kept as it is". */
  readonly effect: string;
}

/** The outcome of reading: a value, if one could be had, and everything worth saying about it. */
export interface Parsed<T> {
  readonly value?: T;
  readonly diagnostics: readonly Diagnostic[];
}

const maximumFound = 40;
const maximumPerFile = 100;

/** Control and format characters (bidi overrides among them) must not act on the page or terminal. */
export function printable(text: string, maximum = maximumFound): string {
  const safe = text.replace(/[\p{Cc}\p{Cf}\p{Zl}\p{Zp}]/gu, '\uFFFD');
  // By characters, so that none is cut in two; at most two code units each.
  const characters = Array.from(safe.slice(0, (maximum + 1) * 2));
  return characters.length > maximum ? `${characters.slice(0, maximum).join('')}…` : safe;
}

/** `FILE:LINE:COL`, of JSON `FILE:LINE:COL (PATH)`, of a binary file `FILE @ byte N (0xN)`. */
export function formatPlace(diagnostic: Diagnostic, maximum = 200): string {
  const { file, line, column, offset, path } = diagnostic;
  const name = printable(file, maximum);
  if (offset !== undefined) return `${name} @ byte ${offset} (0x${offset.toString(16)})`;
  const place = [name, line, column].filter((part) => part !== undefined).join(':');
  return path === undefined ? place : `${place} (${printable(path, 80)})`;
}

/** `PLACE: expected EXPECTED, found "FOUND"`, the form of every message. */
export function formatDiagnostic(diagnostic: Diagnostic): string {
  const { expected, found } = diagnostic;
  // What was expected may name a joint or a file.
  return `${formatPlace(diagnostic)}: expected ${printable(expected, 200)}, found "${printable(found)}"`;
}

export function hasErrors(diagnostics: readonly Diagnostic[]): boolean {
  return diagnostics.some(({ severity }) => severity === 'error');
}

export type DiagnosticDetails = Omit<Diagnostic, 'severity' | 'file'>;

/** Collects the diagnostics of one file; past a hundred it only counts, so that none can flood. */
export class DiagnosticLog {
  private readonly listed: Diagnostic[] = [];
  private omitted = 0;
  private errorCount = 0;
  private readonly file: string;

  constructor(file: string) {
    this.file = file;
  }

  error(details: DiagnosticDetails): void {
    this.errorCount++;
    this.add({ severity: 'error', file: this.file, ...details });
  }

  /** An error that costs a part of the file alone: the rest is a value still. */
  errorOfPart(details: DiagnosticDetails): void {
    this.add({ severity: 'error', file: this.file, ...details });
  }

  warn(details: DiagnosticDetails): void {
    this.add({ severity: 'warning', file: this.file, ...details });
  }

  get failed(): boolean {
    return this.errorCount > 0;
  }

  get diagnostics(): readonly Diagnostic[] {
    if (this.omitted === 0) return this.listed;
    const more: Diagnostic = {
      severity: hasErrors(this.listed) ? 'error' : 'warning',
      code: 'file/more',
      file: this.file,
      expected: 'at most a hundred problems',
      found: `${this.omitted} more`,
      effect: 'they are not listed',
    };
    return [...this.listed, more];
  }

  /** The outcome: a file with an error gives nothing. */
  finish<T>(value: T | undefined): Parsed<T> {
    const { diagnostics } = this;
    return value === undefined || this.failed ? { diagnostics } : { value, diagnostics };
  }

  /** An error takes the place of the last warning, so that warnings can't hide it. */
  private add(diagnostic: Diagnostic): void {
    if (this.listed.length >= maximumPerFile) {
      this.omitted++;
      if (diagnostic.severity === 'warning') return;
      const last = this.listed.findLastIndex(({ severity }) => severity === 'warning');
      if (last === -1) return;
      this.listed.splice(last, 1);
    }
    this.listed.push(diagnostic);
  }
}
