/**
 * A reader reports a problem of a file as a value with place, found, expected and effect, never as
 * an exception. The set of codes is closed, so that tests and translations can refer to them.
 */
export type Severity = 'error' | 'warning';

export type DiagnosticCode = `${DiagnosticArea}/${DiagnosticKind}`;

export type DiagnosticArea =
  | 'file'
  | 'skel'
  | 'obj'
  | 'mtl'
  | 'attach'
  | 'skin'
  | 'morph'
  | 'anim'
  | 'motion'
  | 'rig'
  | 'pmd'
  | 'vpd'
  | 'pose'
  | 'scene'
  | 'character'
  | 'image'
  | 'ik';

export type DiagnosticKind =
  | 'archive' // a zip that can't be unpacked, or one within another
  | 'binary' // text was expected, other bytes were found
  | 'box' // corners in the wrong order
  | 'case' // a keyword in other letter case than the format's
  | 'coincident' // joints at the same point
  | 'continuation' // a line that ends in a continuation, without a next line
  | 'character' // looks like a blank or a minus sign, but is another character
  | 'count' // two counts that should agree
  | 'cycle' // joints that are their own ancestors
  | 'degrees' // angles that look like degrees
  | 'depth' // nested more deeply than Sinew accepts
  | 'duplicate' // given twice
  | 'degenerate' // triangles without area
  | 'empty' // none of the content that the file is for
  | 'encoding' // not UTF-8
  | 'end' // the file ends within something
  | 'face' // an invalid face
  | 'field-count' // too few or too many values on a line
  | 'html' // a web page in place of the file
  | 'ignored' // read and left out on purpose
  | 'index' // refers to something that does not exist
  | 'integer' // a whole number was expected
  | 'json' // not JSON, or not of the expected shape
  | 'limit' // larger than Sinew accepts
  | 'limits' // limits of a joint, in the wrong order
  | 'lost' // can't be stored in the format that is written
  | 'magic' // a file of another kind, by its first bytes
  | 'matrix' // a matrix of the wrong shape
  | 'mirrored' // a matrix that changes the handedness
  | 'missing' // a part of the character is missing
  | 'more' // further diagnostics were left out
  | 'name' // no name, or one that others have
  | 'normal' // no normal, or one of length zero
  | 'number' // a number was expected
  | 'order' // times that do not increase
  | 'pairing' // files that were matched by a guess
  | 'parent' // a parent that does not exist
  | 'pointer' // a placeholder for a file that is stored elsewhere
  | 'range' // a number beyond what can be computed with, or beyond a joint's limits
  | 'rich-text' // written by a word processor
  | 'root' // no root, several, or not the first
  | 'section' // a part of the file is missing
  | 'singular' // a matrix without an inverse
  | 'token' // another word was expected
  | 'trailing' // content after the end of the data
  | 'truncated' // fewer bytes than the file has
  | 'unknown' // no reader knows the file
  | 'unknown-joint' // a joint name that no joint has, or that several have
  | 'unknown-morph' // the same for a morph
  | 'unreadable' // the file exists, but the browser can't read it
  | 'unwritable' // no file can be written there
  | 'uv' // texture coordinates that do not fit
  | 'version' // a version of the format that Sinew does not know
  | 'weight-negative'
  | 'weight-sum'
  | 'weight-zero';

/** A position in a file; without any field, the whole file is meant. */
export interface Place {
  /** One-based. */
  readonly line?: number;
  /** One-based, in bytes of the line; absent if the whole line is meant. */
  readonly column?: number;
  /** For a binary file: the number of bytes before the position. */
  readonly offset?: number;
  /** The line itself, shortened, for the Problems panel. */
  readonly source?: string;
  /** For JSON: the path of the value, such as `joints."Left elbow"[1]`. */
  readonly path?: string;
}

export interface Diagnostic extends Place {
  readonly severity: Severity;
  readonly code: DiagnosticCode;
  readonly file: string;
  readonly expected: string;
  readonly found: string;
  /** The consequence, for the user: "the file is not used", "kept as it is". */
  readonly effect: string;
}

/** The outcome of reading: a value, if possible, and the problems that were found. */
export interface Parsed<T> {
  readonly value?: T;
  readonly diagnostics: readonly Diagnostic[];
}

const maximumFound = 40;
const maximumPerFile = 100;

/**
 * Replaces control and format characters (including bidi overrides), which must not affect the page
 * or the terminal.
 */
export function printable(text: string, maximum = maximumFound): string {
  const safe = withoutControls(text);
  // Counts characters, so that none is cut in two; each has at most two code units.
  const characters = Array.from(safe.slice(0, (maximum + 1) * 2));
  return characters.length > maximum ? `${characters.slice(0, maximum).join('')}…` : safe;
}

/** The same for a path, which is cut at its front because the name of the file is at its end. */
export function printablePath(path: string, maximum = maximumFound): string {
  const safe = withoutControls(path);
  const characters = Array.from(safe.slice(-(maximum + 1) * 2));
  return characters.length > maximum ? `…${characters.slice(-maximum).join('')}` : safe;
}

function withoutControls(text: string): string {
  return text.replace(/[\p{Cc}\p{Cf}\p{Zl}\p{Zp}]/gu, '\uFFFD');
}

/** `FILE:LINE:COL`; for JSON `FILE:LINE:COL (PATH)`; for a binary file `FILE @ byte N (0xN)`. */
export function formatPlace(diagnostic: Diagnostic, maximum = 200): string {
  const { file, line, column, offset, path } = diagnostic;
  const name = printablePath(file, maximum);
  if (offset !== undefined) return `${name} @ byte ${offset} (0x${offset.toString(16)})`;
  const place = [name, line, column].filter((part) => part !== undefined).join(':');
  return path === undefined ? place : `${place} (${printable(path, 80)})`;
}

/** `PLACE: expected EXPECTED, found "FOUND"`, the form of every message. */
export function formatDiagnostic(diagnostic: Diagnostic): string {
  const { expected, found } = diagnostic;
  // The expected text may contain the name of a joint or a file.
  return `${formatPlace(diagnostic)}: expected ${printable(expected, 200)}, found "${printable(found)}"`;
}

export function hasErrors(diagnostics: readonly Diagnostic[]): boolean {
  return diagnostics.some(({ severity }) => severity === 'error');
}

export type DiagnosticDetails = Omit<Diagnostic, 'severity' | 'file'>;

/**
 * Collects the diagnostics of one file. After a hundred it only counts, so that a file can't flood
 * the list.
 */
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

  /** Reports an error that affects only a part of the file; the rest still gives a value. */
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

  /** Returns the outcome: a file with an error has no value. */
  finish<T>(value: T | undefined): Parsed<T> {
    const { diagnostics } = this;
    return value === undefined || this.failed ? { diagnostics } : { value, diagnostics };
  }

  /**
   * When the list is full, an error replaces the last warning, so that warnings can't hide errors.
   */
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
