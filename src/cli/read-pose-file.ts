import { readFileSync } from 'node:fs';
import type { Character } from '../core/character.ts';
import type { Diagnostic, Parsed } from '../core/diagnostics.ts';
import { type Pose, restPose } from '../core/pose.ts';
import { type PoseFormat, poseFormatOf, poseFormats } from '../formats/pose-formats.ts';
import { existingPath } from './existing-path.ts';
import { unreadable, userPath } from './files.ts';

/** Reads a pose by the extension of its file, as POSE.json if no format has that. */
async function readPoseFile(path: string, character: Character): Promise<Parsed<Pose>> {
  let bytes: Uint8Array;
  try {
    bytes = new Uint8Array(readFileSync(existingPath(userPath(path))));
  } catch (error) {
    return { diagnostics: [unreadable(path, error)] };
  }
  const { skeleton, morphs } = character;
  const rest = { ...restPose(skeleton), morphWeights: new Float64Array(morphs.length) };
  const { read } = await formatOfPose(path).load();
  return read(path, bytes, character, rest);
}

/** The pose of a file if one is given, in the angles of the character's files; else their own pose. */
export async function givenPose(
  path: string | undefined,
  character: Character,
  found: Diagnostic[],
): Promise<Pose | undefined> {
  if (path === undefined) return restPose(character.skeleton);
  const { value, diagnostics } = await readPoseFile(path, character);
  found.push(...diagnostics);
  return value;
}

export function formatOfPose(path: string): PoseFormat {
  return poseFormatOf(path) ?? poseFormats[0]!;
}
