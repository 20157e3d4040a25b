import type { Character } from '../core/character.ts';
import { hasErrors } from '../core/diagnostics.ts';
import type { Pose } from '../core/pose.ts';
import { readCharacters } from '../formats/read-characters.ts';
import { printDiagnostics, readFiles } from './files.ts';
import { givenPose } from './read-pose-file.ts';
import { UsageError } from './usage-error.ts';

/**
 * Reads the files of one character that has a mesh, and a pose or the files' own. Prints problems;
 * returns nothing if they keep it from being used.
 */
export async function readPosed(
  paths: readonly string[],
  posePath: string | undefined,
): Promise<{ readonly character: Character; readonly pose: Pose } | undefined> {
  const { files, diagnostics: missing } = readFiles(paths);
  const { characters, diagnostics } = await readCharacters(files);
  const found = [...missing, ...diagnostics];
  const character = characters[0]?.character;
  const pose = character && (await givenPose(posePath, character, found));
  printDiagnostics(found);
  if (characters.length > 1) throw new UsageError('expected the files of one character');
  const hasMesh = character !== undefined && character.mesh.pointCount > 0;
  if (character && !hasMesh) console.error('error: there is no mesh to pose');
  return hasMesh && pose && !hasErrors(found) ? { character, pose } : undefined;
}
