import { zipSync } from 'fflate';
import type { Character } from '../core/character.ts';
import { type Diagnostic, hasErrors } from '../core/diagnostics.ts';
import type { Pose } from '../core/pose.ts';
import { convertCharacter } from '../formats/convert.ts';
import { type ConvertTarget, loadWriter, shapeOf, writtenWord } from '../formats/registry.ts';
import { savedFiles } from '../formats/saved-files.ts';
import { poseToJson } from '../formats/write-pose-json.ts';
import { download } from './download.ts';

/**
 * Downloads an archive with the character in a course's format, the matching pose, and the images
 * of its materials; nothing if the format can't hold the character.
 *
 * @returns what the format can't hold
 */
export async function saveAs(
  character: Character,
  pose: Pose,
  format: ConvertTarget,
): Promise<readonly Diagnostic[]> {
  const converted = convertCharacter(character, format, pose);
  const write = await loadWriter(format);
  const { files, losses } = write(converted.character);
  if (hasErrors(losses)) return losses;
  const { skeleton } = converted.character;
  const poseJson = `${JSON.stringify(poseToJson(skeleton, converted.pose), null, 2)}\n`;
  const poseFile = {
    path: `${character.name}.pose.json`,
    bytes: new TextEncoder().encode(poseJson),
  };
  const images = shapeOf(format).textures ? character.images : [];
  const saved = savedFiles([...files, poseFile], images);
  const archive = zipSync(Object.fromEntries(saved.map(({ path, bytes }) => [path, bytes])));
  download(`${character.name}-${writtenWord(format)}.zip`, archive, 'application/zip');
  return [...converted.losses, ...losses];
}
