import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import type { Character } from '../core/character.ts';
import { type Diagnostic, hasErrors } from '../core/diagnostics.ts';
import type { Pose } from '../core/pose.ts';
import { convertCharacter } from '../formats/convert.ts';
import { baseName } from '../formats/file-entry.ts';
import type { OutputFile, Written } from '../formats/format.ts';
import { holdsPosesOf, poseFormats } from '../formats/pose-formats.ts';
import { poseToJson } from '../formats/write-pose-json.ts';
import { readCharacters } from '../formats/read-characters.ts';
import { convertTargets, loadWriter, writtenWord } from '../formats/registry.ts';
import { savedFiles } from '../formats/saved-files.ts';
import { writeConvertedMotion } from '../formats/write-converted-motion.ts';
import type { Command } from './command.ts';
import { printDiagnostics, readFiles, unwritable, userPath } from './files.ts';
import { parseWords } from './parse-words.ts';
import { readMotionFile, unusedMotion } from './read-motion-file.ts';
import { formatOfPose, givenPose } from './read-pose-file.ts';
import { UsageError } from './usage-error.ts';

const words = convertTargets.map(writtenWord);
const usage = `convert FILES --to ${words.join('|')} --out DIR [--pose POSE.json|POSE.vpd] [--motion MOTION.json|CLIP.anim]`;

/** `convert FILES --to FORMAT --out DIR [--pose POSE] [--motion MOTION]` writes the files of another format. */
export const convert: Command = {
  name: 'convert',
  usage,
  summary:
    'Writes one character, and a pose and a motion if they are given, as the files of a course, and reports what is lost. A motion becomes an .anim for CSE169, otherwise a MOTION.json.',
  async run(words) {
    const options = parseOptions(words);
    const { files, diagnostics: missing } = readFiles(options.files);
    const { characters, diagnostics } = await readCharacters(files);
    const found: Diagnostic[] = [...missing, ...diagnostics];
    if (characters.length > 1) throw new UsageError('expected the files of one character');
    const character = characters[0]?.character;
    const pose = character && (await givenPose(options.pose, character, found));
    const motion =
      character && options.motion !== undefined
        ? await readMotionFile(options.motion, character)
        : { diagnostics: [] };
    found.push(...motion.diagnostics);
    if (!character || !pose || hasErrors(found)) {
      printDiagnostics(found);
      if (hasErrors(motion.diagnostics)) console.error(unusedMotion);
      return 1;
    }
    const converted = convertCharacter(character, options.to, pose);
    const write = await loadWriter(options.to);
    const { files: written, losses } = write(converted.character);
    printDiagnostics([...found, ...converted.losses, ...losses]);
    if (hasErrors(losses)) return 1;
    const poseFile = await writtenPose(options.pose, converted.character, converted.pose);
    const motionFile = motion.value && writeConvertedMotion(motion.value, converted, options.to);
    const lostLast = [...poseFile.losses, ...(motionFile?.losses ?? [])];
    printDiagnostics(lostLast);
    if (hasErrors(lostLast)) return 1;
    const all = [...written, ...poseFile.files, ...(motionFile?.files ?? [])];
    return writeAll(options.out, all) ? 0 : 1;
  },
};

function parseOptions(words: readonly string[]) {
  const { values, positionals: files } = parseWords(() =>
    parseArgs({
      args: [...words],
      options: {
        to: { type: 'string' },
        out: { type: 'string' },
        pose: { type: 'string' },
        motion: { type: 'string' },
      },
      allowPositionals: true,
    }),
  );
  const { to, out, pose, motion } = values;
  if (files.length === 0) throw new UsageError('expected files, found none');
  const target = convertTargets.find((id) => writtenWord(id) === to);
  if (!target) throw new UsageError(`expected ${words.map((word) => `--to ${word}`).join(' or ')}`);
  if (out === undefined) throw new UsageError('expected --out with a folder');
  return { files, to: target, out, pose, motion };
}

/**
 * The pose file to write: the given pose under its own name, or as POSE.json where its format can't
 * hold the poses of the written files. Without one, the file's pose, but only if the written files
 * rest in a different pose.
 */
async function writtenPose(
  path: string | undefined,
  character: Character,
  pose: Pose,
): Promise<Written> {
  const json = poseToJson(character.skeleton, pose);
  const isRest = Object.keys(json.joints ?? {}).length === 0 && !json.root;
  if (path === undefined && isRest) return { files: [], losses: [] };
  const asked = formatOfPose(path ?? '');
  const isHeld = holdsPosesOf(asked, character);
  const { write } = await (isHeld ? asked : poseFormats[0]!).load();
  const morphWeights = pose.morphWeights ?? new Float64Array(character.morphs.length);
  const written = write(character, { morphWeights, ...pose });
  if (path === undefined || !isHeld) return written;
  const files = written.files.map(({ bytes }) => ({ path: baseName(path), bytes }));
  return { ...written, files };
}

function writeAll(folder: string, files: readonly OutputFile[]): boolean {
  try {
    mkdirSync(userPath(folder), { recursive: true });
    for (const { path, bytes } of savedFiles(files)) {
      const target = join(folder, path);
      writeFileSync(userPath(target), bytes);
      console.log(target);
    }
    return true;
  } catch (error) {
    printDiagnostics([unwritable(folder, error)]);
    return false;
  }
}
