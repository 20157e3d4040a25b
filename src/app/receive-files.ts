import type { Diagnostic } from '../core/diagnostics.ts';
import { loadPart } from '../core/failure.ts';
import { sceneExtension } from '../formats/extensions.ts';
import { pathStem } from '../formats/file-entry.ts';
import type { FileEntry } from '../formats/format.ts';
import type { ReadCharacter } from '../formats/read-characters.ts';
import { askToAdd } from './ask-to-add.ts';
import { openOwnFiles } from './open-own-files.ts';
import { rememberFiles } from './recent-files.ts';
import { type GivenScene, sceneAmong } from './scenes/scene-among.ts';
import type { SceneParts } from './scenes/scene-parts.ts';

/** The number of your own characters that stay in the list in addition to those opened last. */
const mostEarlier = 12;

/** What receives the user's files. */
interface Receiver extends SceneParts {
  /** Opens a bundled character as a part of this opening. */
  readonly openBundled: (id: string) => Promise<void>;
  readonly showOpened: (name: string, what: string) => void;
}

/** How files were received; see `Opening.openFiles`. */
interface Received {
  readonly files: readonly FileEntry[];
  readonly add: boolean | 'ask';
  readonly handles: readonly FileSystemHandle[];
}

/** Opens the user's files, says what came of it, and lists and remembers them. */
export async function receiveFiles(
  receiver: Receiver,
  { files, add, handles }: Received,
  signal: AbortSignal,
): Promise<void> {
  const { opening, opener, own, meter, openBundled, showOpened } = receiver;
  if (await opening.wanted.value?.give(files, signal)) return;
  const problems: Diagnostic[] = [];
  const scene = await sceneAmong(files, problems);
  if (signal.aborted) return;
  if (scene ?? problems.length > 0) {
    const opened = await receiveScene(receiver, scene, signal, { add: add === true, problems });
    if (!opened) return;
    const [handle] = handles;
    const isFile =
      handles.length === 1 && handle?.name === scene!.file && handle.name.endsWith(sceneExtension);
    if (isFile && add !== true) receiver.target.handle = handle as FileSystemFileHandle;
    await rememberFiles(scene!.file, handles);
    return;
  }
  const ask = (found: readonly ReadCharacter[]): Promise<boolean | null> => {
    meter.clear(); // the question would stand over it
    return askToAdd(opening, nameOf(found), opener.selected!.name, signal);
  };
  const outcome = await openOwnFiles(opener, files, {
    signal,
    onProgress: meter.report,
    openBundled,
    add: add === true,
    ...(add === 'ask' && { ask }),
  });
  if (!outcome) return;
  const { found, opened, reopened, posed, added } = outcome;
  if (!opened) {
    opening.notice.value = posed ? 'Pose set' : 'Nothing could be opened; see Problems';
    return;
  }
  // If files that were opened before are opened again, the list shows them once.
  const came = new Set(found.flatMap(pathsOf));
  const earlier = own.value.filter((read) => !pathsOf(read).every((path) => came.has(path)));
  own.value = [...earlier.slice(-mostEarlier), ...found];
  const beside = added ? 'added' : 'opened';
  showOpened(nameOf(found), reopened ? 'updated; pose and camera kept' : beside);
  await rememberFiles(nameOf(found), handles);
}

/** Opens a scene, if one could be read from its file; returns whether it was opened. */
async function receiveScene(
  parts: SceneParts,
  scene: GivenScene | undefined,
  signal: AbortSignal,
  { add, problems }: { readonly add: boolean; readonly problems: readonly Diagnostic[] },
): Promise<boolean> {
  const { session, notice } = parts.opening;
  const { openGivenScene } = await loadPart(import('./scenes/open-given-scene.ts'));
  const name = scene && pathStem(scene.file);
  if (scene && (await openGivenScene(parts, scene, signal, { name: name!, add, problems }))) {
    return true;
  }
  if (signal.aborted) return false;
  if (!scene) session.problems.value = problems;
  notice.value = 'The scene could not be opened; see Problems';
  return false;
}

/** What several characters are called together: the first one's name and the count of the others. */
function nameOf([first, ...others]: readonly ReadCharacter[]): string {
  const more = others.length > 0 ? ` and ${others.length} more` : '';
  return `${first?.character.name ?? ''}${more}`;
}

function pathsOf({ files }: ReadCharacter): string[] {
  return files.map(({ path }) => path);
}
