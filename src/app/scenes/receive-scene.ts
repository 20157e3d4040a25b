import type { Diagnostic } from '../../core/diagnostics.ts';
import { loadPart } from '../../core/failure.ts';
import { pathStem } from '../../formats/file-entry.ts';
import type { FileEntry } from '../../formats/format.ts';
import { rememberFiles } from '../recent-files.ts';
import { sceneAmong } from './scene-among.ts';
import type { SceneParts } from './scene-parts.ts';

/** Files that came, and how; see `Opening.openFiles`. */
interface Received {
  readonly files: readonly FileEntry[];
  readonly add: boolean;
  readonly handles: readonly FileSystemHandle[];
}

/**
 * Opens the scene that is among files, and says what came of it.
 *
 * @returns false if there is none, so that the files are opened in another way
 */
export async function receiveScene(
  parts: SceneParts,
  { files, add, handles }: Received,
  signal: AbortSignal,
): Promise<boolean> {
  const problems: Diagnostic[] = [];
  const scene = await sceneAmong(files, problems);
  if (!scene && problems.length === 0) return false;
  const { session, notice } = parts.opening;
  const { openGivenScene, whyRefused } = await loadPart(import('./open-given-scene.ts'));
  if (scene) {
    const handle = handles.find((each): each is FileSystemFileHandle => each.name === scene.file);
    // A picture keeps its scene, but is not what the scene is saved in.
    const target = handle && scene.isFile ? { handle } : {};
    const how = { name: pathStem(scene.file), add, target, problems };
    if (await openGivenScene(parts, scene, signal, how)) {
      await rememberFiles(scene.file, handles);
      return true;
    }
  } else session.problems.value = problems;
  if (!signal.aborted) notice.value = `The scene could not be opened: ${whyRefused(parts)}`;
  return true;
}
