import type { Character } from '../core/character.ts';
import type { CharacterParts, FileSpace } from '../core/character-parts.ts';
import type { Diagnostic, Parsed } from '../core/diagnostics.ts';
import type { EulerProduct } from '../core/euler.ts';
import type { Limits } from '../core/limits.ts';
import type { SkinnedNormalsId } from '../core/skin.ts';

/** A file that was dropped, fetched or named on the command line; its bytes are read on request. */
export interface FileEntry {
  /** The path as given, possibly with folders, separated by `/`. */
  readonly path: string;
  readonly size: number;
  /**
   * The first 4 KiB, so that a format can recognize its files by content. If all bytes are in
   * memory, they start after leading comments, which may be longer.
   */
  readonly head: Uint8Array;
  /** The SHA-256 of its bytes in hexadecimal digits, if it is known. */
  readonly sha256?: string;
  /** The reason why it can't be read, if that is known before its bytes are requested. */
  readonly fault?: string;
  bytes(): Promise<Uint8Array>;
}

/** The files of one character. */
export interface FileGroup {
  readonly name: string;
  readonly files: readonly FileEntry[];
  /** Reports of guesses in grouping the files. */
  readonly diagnostics: readonly Diagnostic[];
}

export interface OutputFile {
  readonly path: string;
  readonly bytes: Uint8Array;
}

export interface Written {
  readonly files: readonly OutputFile[];
  /** What the character has but the files can't hold; with an error, no files are written. */
  readonly losses: readonly Diagnostic[];
}

/** Reads the files of a format into loose parts. */
export interface FormatReader {
  /** Groups the files of each character. */
  group(files: readonly FileEntry[]): Promise<readonly FileGroup[]>;
  read(group: FileGroup, limits: Limits): Promise<Parsed<CharacterParts>>;
}

/** Writes a file for each part of a character that exists. */
export type FormatWriter = (character: Character) => Written;

/**
 * What the files of a format can hold, as data. Conversion, `Save as` and the report of losses read
 * it, so that none of them depends on a particular format.
 */
export interface FormatShape {
  /** The course or program that uses these files, for reports. */
  readonly owner: string;
  /** Which joints can be translated along x, y and z before they rotate. */
  readonly slides: 'roots' | 'any';
  /** How each joint rotates: by three hinges in the order of the product, or as a ball. */
  readonly turns: EulerProduct | 'ball';
  /** Whether joints can have a rotation at rest, apart from their values. */
  readonly restRotations: boolean;
  /** Whether the files have a pose of their own; otherwise it is zero or the identity. */
  readonly restPose: boolean;
  readonly limits: boolean;
  /**
   * How the files name joints: not at all, by one word each, or in fields of 20 bytes in Shift-JIS.
   */
  readonly jointNames: false | 'words' | 'fields';
  readonly jointBoxes: boolean;
  /**
   * Whether the files have bindings of their own; otherwise the mesh is bound to the joints at
   * rest.
   */
  readonly bindings: boolean;
  /** Whether points can follow the first joint. */
  readonly firstJointWeights: boolean;
  /** The largest number of influences of a vertex. */
  readonly influences: number;
  /** How the format's programs transform normals. */
  readonly normals: SkinnedNormalsId;
  /**
   * Whether the format's programs take normals from the files; otherwise they compute them from the
   * triangles.
   */
  readonly ownNormals: boolean;
  /** Whether materials name images, and whether they have colors. */
  readonly textures: boolean;
  readonly colors: boolean;
  readonly morphs: boolean;
  readonly clips: boolean;
  /** Whether the files nest joints in one another, so that these are numbered depth first. */
  readonly nests: boolean;
  /** Null if the format does not define its unit. */
  readonly metersPerUnit: number | null;
  readonly handedness: FileSpace;
}
