import type { Character } from '../core/character.ts';
import type { Parsed } from '../core/diagnostics.ts';
import { loadPart } from '../core/failure.ts';
import type { Pose } from '../core/pose.ts';
import { DofKind } from '../core/skeleton.ts';
import { extensionOf } from './file-entry.ts';
import type { Written } from './format.ts';

/** Reads and writes the poses of one format. */
export interface PoseCodec {
  /**
   * Returns the pose of a file for a character. A format whose files may have a part of a pose puts
   * it onto what is shown.
   */
  readonly read: (
    file: string,
    bytes: Uint8Array,
    character: Character,
    shown: Required<Pose>,
  ) => Parsed<Pose>;
  readonly write: (character: Character, pose: Required<Pose>) => Written;
}

/** What a format can hold, as data. */
export interface PoseShape {
  /** How joints rotate; `any` if the format has values for all. */
  readonly turns: 'any' | 'ball';
  readonly morphs: boolean;
}

/** A format of poses. To add one, write its codec and add a row below. */
export interface PoseFormat {
  readonly id: string;
  readonly label: string;
  /** Lower case, with the dot. */
  readonly extension: string;
  readonly shape: PoseShape;
  readonly load: () => Promise<PoseCodec>;
}

export const poseFormats: readonly PoseFormat[] = [
  {
    id: 'json',
    label: 'POSE.json',
    extension: '.json',
    shape: { turns: 'any', morphs: false },
    load: async () => (await loadPart(import('./pose-json-codec.ts'))).poseJsonCodec,
  },
  {
    id: 'vpd',
    label: 'MikuMikuDance pose',
    extension: '.vpd',
    shape: { turns: 'ball', morphs: true },
    load: async () => (await loadPart(import('./mmd/vpd-codec.ts'))).vpdCodec,
  },
];

/** The format of a file by its extension, or nothing if it is no pose. */
export function poseFormatOf(path: string): PoseFormat | undefined {
  const extension = extensionOf(path);
  return poseFormats.find((each) => each.extension === extension);
}

/** Whether a format can hold the poses of a character, which then has joints. */
export function holdsPosesOf({ shape }: PoseFormat, { skeleton }: Character): boolean {
  if (skeleton.jointCount === 0) return false;
  return shape.turns === 'any' || skeleton.dofKind.every((kind) => kind !== DofKind.hinge);
}
