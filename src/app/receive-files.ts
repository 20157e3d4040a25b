import { printable } from '../core/diagnostics.ts';
import type { FileEntry } from '../formats/format.ts';
import type { ReadCharacter } from '../formats/read-characters.ts';
import { askToAdd } from './ask-to-add.ts';
import { openOwnFiles } from './open-own-files.ts';
import { rememberFiles } from './recent-files.ts';
import { receiveScene } from './scenes/receive-scene.ts';
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
  if (await receiveScene(receiver, { files, add: add === true, handles }, signal)) return;
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
  const { found, opened, kept, posed, cover, motion, added } = outcome;
  if (!opened) {
    if (motion !== undefined) opening.notice.value = motion;
    else if (cover !== undefined) {
      const covered = printable(opener.selected?.name ?? '', 60);
      opening.notice.value = `${printable(cover, 60)} covers ${covered}; Undo takes it off`;
    } else {
      opening.notice.value = posed ? 'Pose set' : 'Nothing could be opened; see Problems';
    }
    return;
  }
  // If files that were opened before are opened again, the list shows them once.
  const came = new Set(found.flatMap(pathsOf));
  const earlier = own.value.filter((read) => !pathsOf(read).every((path) => came.has(path)));
  own.value = [...earlier.slice(-mostEarlier), ...found];
  // A character of bones alone would not be seen.
  if (found.some(({ character }) => character.mesh.pointCount === 0)) {
    opening.session.showSkeleton.value = true;
  }
  const beside = added ? 'added' : 'opened';
  showOpened(nameOf(found), kept === undefined ? beside : `updated; ${kept}`);
  await rememberFiles(nameOf(found), handles);
}

/** What several characters are called together: the first one's name and the count of the others. */
function nameOf([first, ...others]: readonly ReadCharacter[]): string {
  const more = others.length > 0 ? ` and ${others.length} more` : '';
  return `${first?.character.name ?? ''}${more}`;
}

function pathsOf({ files }: ReadCharacter): string[] {
  return files.map(({ path }) => path);
}
