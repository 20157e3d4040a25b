import type { Character } from '../core/character.ts';
import { Failure } from '../core/failure.ts';
import { decodeText } from '../formats/text/decode-text.ts';
import { poseFromJson, type PoseJson } from '../formats/pose-json.ts';
import { namePose } from '../posing/named-pose.ts';
import type { BundledPose } from '../ui/editor.ts';
import { dataUrl } from './catalogue.ts';
import { fetchFile } from './fetch-file.ts';

/** What the list of a bundled character's poses has. */
export interface PoseList {
  /** The joints that every pose sets; all of the character, if absent. */
  readonly joints?: readonly string[];
  readonly poses: readonly { readonly name: string; readonly pose: PoseJson }[];
}

/**
 * Fetches the poses that come with a bundled character.
 *
 * @param path of their list, relative to the catalogue
 */
export async function fetchBundledPoses(
  path: string,
  character: Character,
): Promise<readonly BundledPose[]> {
  const { bytes } = await fetchFile(new URL(path, dataUrl()));
  const { joints, poses } = parseList(path, decodeText(bytes));
  const { names } = character.skeleton;
  const named = (joints ?? names).map((name) => names.indexOf(name)).filter((joint) => joint >= 0);
  return poses.flatMap(({ name, pose }) => {
    const { value } = poseFromJson(path, pose, character.skeleton);
    return value ? [{ name, pose: { ...namePose(character, value, named), morphs: [] } }] : [];
  });
}

function parseList(path: string, text: string): PoseList {
  try {
    return JSON.parse(text) as PoseList;
  } catch {
    throw new Failure(`${path} came damaged; reload the page`);
  }
}
