import { type Diagnostic, printablePath } from '../../core/diagnostics.ts';
import { baseName, extensionOf, pathStem } from '../file-entry.ts';
import type { FileEntry, FileGroup } from '../format.ts';
import { foldersOf, nameKey, sharedTail } from './paths.ts';

/** The file extensions of a character's parts. */
export interface PartKinds {
  /**
   * A character has at most one file of each of these; the first that exists names the character.
   */
  readonly single: readonly string[];
  /** A character has any number of these; their names usually begin with the character's name. */
  readonly many: readonly string[];
}

/** The files of a character while more of them are being found. */
export class Draft {
  /**
   * Its files of single kinds, and their names and folders in the form in which they are compared.
   */
  readonly parts: FileEntry[];
  readonly stems: string[];
  readonly folders: (readonly string[])[];
  /** Its other files. */
  readonly companions: FileEntry[] = [];
  readonly diagnostics: Diagnostic[] = [];
  /** The draft that took over this one's files. */
  private heir: Draft | undefined;
  private isGuess = false;

  constructor(parts: readonly FileEntry[]) {
    this.parts = [...parts];
    this.stems = parts.map(({ path }) => stemOf(path));
    this.folders = parts.map(({ path }) => foldersOf(path));
  }

  /** The draft that has this one's files now. */
  get current(): Draft {
    return this.heir?.current ?? this;
  }

  get firstPath(): string {
    return this.parts[0]!.path;
  }

  /** Whether both can belong to one character. */
  fits(other: Draft): boolean {
    const kinds = new Set(this.parts.map(({ path }) => extensionOf(path)));
    return other !== this && !other.parts.some(({ path }) => kinds.has(extensionOf(path)));
  }

  sharesFolder(other: Draft): boolean {
    const own = new Set(this.folders.map((folders) => folders.join('/')));
    return other.folders.some((folders) => own.has(folders.join('/')));
  }

  /** The number of innermost folders that have the same names. */
  sharedTail(other: readonly (readonly string[])[]): number {
    return Math.max(...this.folders.flatMap((own) => other.map((each) => sharedTail(own, each))));
  }

  take(other: Draft, isGuess: boolean): void {
    this.parts.push(...other.parts);
    this.stems.push(...other.stems);
    this.folders.push(...other.folders);
    this.companions.push(...other.companions);
    this.diagnostics.push(...other.diagnostics);
    this.isGuess ||= isGuess || other.isGuess;
    other.heir = this;
  }

  takeCompanion(file: FileEntry, isGuess: boolean): void {
    this.companions.push(file);
    this.isGuess ||= isGuess;
  }

  /** @param order of the input files */
  finish({ single }: PartKinds, order: ReadonlyMap<FileEntry, number>): FileGroup {
    const files = [...new Set([...this.parts, ...this.companions])];
    files.sort((a, b) => order.get(a)! - order.get(b)!);
    const rank = ({ path }: FileEntry): number => single.indexOf(extensionOf(path));
    const sorted = [...this.parts.toSorted((a, b) => rank(a) - rank(b)), ...this.companions];
    const name = baseName(pathStem((sorted[0] ?? files[0])!.path));
    const diagnostics = [...this.diagnostics, ...(this.isGuess ? [joined(sorted)] : [])];
    return { name, files, diagnostics };
  }
}

/** A file's name without its extension, in the form in which names are compared. */
export function stemOf(path: string): string {
  return nameKey(pathStem(baseName(path)));
}

const mostShown = 4;

/** Reports the guess once per character, however many files it has. */
function joined(files: readonly FileEntry[]): Diagnostic {
  const names = files.map(({ path }) => baseName(path));
  const isOneFolder = new Set(files.map(({ path }) => foldersOf(path).join('/'))).size === 1;
  const shown = files
    .slice(0, mostShown)
    .map(({ path }) => printablePath(isOneFolder ? baseName(path) : path));
  const more = files.length > mostShown ? ` and ${files.length - mostShown} more` : '';
  return {
    severity: 'warning',
    code: 'file/pairing',
    file: names[0]!,
    expected: 'files of one name in one folder',
    found: names.slice(1).join(', '),
    effect: `${more ? shown.join(', ') + more : shown.join(' and ')} are read as one character`,
  };
}
