import type { Character } from '../core/character.ts';
import type { CharacterParts } from '../core/character-parts.ts';
import type { Diagnostic, Parsed } from '../core/diagnostics.ts';
import type { Limits } from '../core/limits.ts';

/** A file that was dropped, fetched or named on the command line; its bytes come when asked for. */
export interface FileEntry {
  /** As given: perhaps with folders, `/` between them. */
  readonly path: string;
  readonly size: number;
  /** The first 4 KiB, so that a format can tell its dialect by content. */
  readonly head: Uint8Array;
  bytes(): Promise<Uint8Array>;
}

/** The files of one character. */
export interface FileGroup {
  readonly name: string;
  readonly files: readonly FileEntry[];
  /** What was guessed in putting them together. */
  readonly diagnostics: readonly Diagnostic[];
}

export interface OutputFile {
  readonly path: string;
  readonly bytes: Uint8Array;
}

export interface Written {
  readonly files: readonly OutputFile[];
  /** What the character has and the files can't hold. */
  readonly losses: readonly Diagnostic[];
}

/** Half of a seam: from a format's files to loose parts. */
export interface FormatReader {
  /** Puts the files of each character together. */
  group(files: readonly FileEntry[]): readonly FileGroup[];
  read(group: FileGroup, limits: Limits): Promise<Parsed<CharacterParts>>;
}

/** The other half: a file for each part that there is. */
export type FormatWriter = (character: Character) => Written;
