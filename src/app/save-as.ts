import { zipSync } from 'fflate';
import type { Character } from '../core/character.ts';
import { type Diagnostic, hasErrors } from '../core/diagnostics.ts';
import type { Pose } from '../core/pose.ts';
import type { Actor } from '../document/scene.ts';
import { convertCharacter } from '../formats/convert.ts';
import type { OutputFile } from '../formats/format.ts';
import { type ConvertTarget, loadWriter, shapeOf, writtenWord } from '../formats/registry.ts';
import { savedFiles } from '../formats/saved-files.ts';
import { writeMotionsBeside } from '../formats/write-converted-motion.ts';
import { poseToJson } from '../formats/write-pose-json.ts';
import { download } from '../ui/download.ts';

/** What came of a character that is saved in another format. */
interface SavedAs {
  /** What the format can't hold; with an error, nothing was saved. */
  readonly losses: readonly Diagnostic[];
  /** How many motions are beside the character as MOTION.json, since its format can't hold them. */
  readonly motionsBeside: number;
}

/**
 * Downloads an archive with the character in a course's format, the matching pose, its motions, and
 * the images of its materials; nothing if the format can't hold the character.
 */
export async function saveAs(
  { character, skin, clips }: Pick<Actor, 'character' | 'skin' | 'clips'>,
  pose: Pose,
  format: ConvertTarget,
): Promise<SavedAs> {
  // The actor's clips and weights are the present ones; the character's are as they were opened.
  const present = { ...character, skin: skin ?? character.skin, clips: [] };
  const converted = convertCharacter(present, format, pose);
  const write = await loadWriter(format);
  const { files, losses } = write(converted.character);
  if (hasErrors(losses)) return { losses, motionsBeside: 0 };
  const motions = writeMotionsBeside(clips, converted, format);
  const all = [...files, poseFile(character.name, converted), ...motions.files];
  const images = shapeOf(format).textures ? character.images : [];
  const saved = savedFiles(all, images);
  const archive = zipSync(Object.fromEntries(saved.map(({ path, bytes }) => [path, bytes])));
  download(`${character.name}-${writtenWord(format)}.zip`, archive, 'application/zip');
  return {
    losses: [...converted.losses, ...losses, ...motions.losses],
    motionsBeside: motions.files.filter(({ path }) => path.endsWith('.motion.json')).length,
  };
}

function poseFile(
  name: string,
  { character, pose }: { readonly character: Character; readonly pose: Pose },
): OutputFile {
  const json = `${JSON.stringify(poseToJson(character.skeleton, pose), null, 2)}\n`;
  return { path: `${name}.pose.json`, bytes: new TextEncoder().encode(json) };
}
