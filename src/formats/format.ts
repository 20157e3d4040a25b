import type { Character } from '../core/character.ts';
import type { CharacterParts, FileSpace } from '../core/character-parts.ts';
import type { Diagnostic, Parsed } from '../core/diagnostics.ts';
import type { EulerProduct } from '../core/euler.ts';
import type { Limits } from '../core/limits.ts';
import type { NormalsId } from '../core/skin.ts';

/** A file that was dropped, fetched or named on the command line; its bytes come when asked for. */
export interface FileEntry {
  /** As given: perhaps with folders, `/` between them. */
  readonly path: string;
  readonly size: number;
  /** The first 4 KiB, so that a format can tell its dialect by content. */
  readonly head: Uint8Array;
  /** Why it can't be read, where that is known before its bytes are asked for. */
  readonly fault?: string;
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
  group(files: readonly FileEntry[]): Promise<readonly FileGroup[]>;
  read(group: FileGroup, limits: Limits): Promise<Parsed<CharacterParts>>;
}

/** The other half: a file for each part that there is. */
export type FormatWriter = (character: Character) => Written;

/**
 * What the files of a format can hold, as data: converting, `Save as` and the report of losses read it,
 * so that none of them knows a format by its name.
 */
export interface FormatShape {
  /** The course or program whose files they are, for reports. */
  readonly owner: string;
  /** Which joints can be moved, along x, y and z, before they turn. */
  readonly slides: 'roots' | 'any';
  /** How each joint turns: by three hinges in the order of the product, or as a ball. */
  readonly turns: EulerProduct | 'ball';
  /** Whether joints can be rotated at rest, apart from their values. */
  readonly restRotations: boolean;
  /** Whether values have a pose of the file's own, else zero or the identity. */
  readonly restPose: boolean;
  readonly limits: boolean;
  readonly jointNames: boolean;
  readonly jointBoxes: boolean;
  /** Whether bindings are the file's own; else the mesh is bound to the joints as they stand at rest. */
  readonly bindings: boolean;
  /** Whether points can follow the first joint. */
  readonly firstJointWeights: boolean;
  /** The most that a vertex can have. */
  readonly influences: number;
  /** How the format's programs turn normals. */
  readonly normals: NormalsId;
  /** Whether the format's programs take normals from the files; else they compute them from the triangles. */
  readonly ownNormals: boolean;
  /** Whether materials name images, and whether they have colors. */
  readonly textures: boolean;
  readonly colors: boolean;
  readonly morphs: boolean;
  readonly clips: boolean;
  /** Null where the format says nothing of it. */
  readonly metersPerUnit: number | null;
  readonly handedness: FileSpace;
}
