import { headSize } from '../../formats/file-entry.ts';
import type { FileEntry } from '../../formats/format.ts';
import { timeText } from '../../ui/time-text.ts';
import { keepScene, keptFiles, type KeptScene, listKept } from './kept-scenes.ts';
import { openGivenScene, whyRefused } from './open-given-scene.ts';
import { keptMarker } from './at-start.ts';
import { isReload } from './is-reload.ts';
import { holdScene, openScenes } from './scene-locks.ts';
import type { SceneParts } from './scene-parts.ts';
import { freshTarget } from './scene-target.ts';

/** In milliseconds. A browser whose database does not answer must not keep the page waiting. */
const patience = 3000;

/** How long the page before a reload may take to end. */
const endingPatience = 1000;

/**
 * Restores the scene that this tab had before a reload, or else the one that was changed last, unless
 * it is open in another tab.
 *
 * @param orLast whether it may be another scene than this tab's own
 * @returns a message about it, or nothing if there is none to restore
 */
export async function restoreLast(
  parts: SceneParts,
  orLast: boolean,
): Promise<{ readonly message: string; readonly opened: boolean } | undefined> {
  try {
    const listed = await Promise.race([listKept(), tooLate(patience)]);
    const [found, isOwn] = chosen(listed, orLast);
    if (!found) return undefined;
    const isOpen = await openScenes();
    if (!isOwn && isOpen(found.id)) return undefined;
    const release = await holdScene(found.id, isOwn ? endingPatience : 0);
    release?.(); // what keeps the scene takes the lock again
    const opened = await openKept(parts, found, release ? found.id : undefined);
    const when = timeText(new Date(found.time), new Date());
    if (opened) return { message: `Restored the scene of ${when}`, opened };
    await keepScene({ ...found, isRefused: true }, new Map(), () => true);
    return {
      message: `The scene of ${when} could not be restored: ${whyRefused(parts)}`,
      opened,
    };
  } catch {
    return { message: 'This browser could not give back the scene that it kept', opened: false };
  }
}

/** The scene to restore, and whether it is this tab's own. */
function chosen(
  listed: readonly KeptScene[],
  orLast: boolean,
): readonly [KeptScene | undefined, boolean] {
  const id = isReload() ? sessionStorage.getItem(keptMarker) : null;
  const own = listed.find((each) => each.id === id);
  const found = own ?? (orLast ? listed[0] : undefined);
  return [found?.isRefused ? undefined : found, own !== undefined];
}

/**
 * Opens a scene that was kept.
 *
 * @param id under which it is kept from now on; another one, if absent
 */
export async function openKept(
  parts: SceneParts,
  kept: KeptScene,
  id = freshTarget().id,
): Promise<boolean> {
  const files = Array.from(await keptFiles(kept), asEntry);
  const given = { file: 'kept scene', text: kept.text, files: await Promise.all(files) };
  const how = { name: kept.name, target: { id } };
  const opened = await parts.opening.whileWorking(`Opening ${kept.name}`, (signal) =>
    openGivenScene(parts, given, signal, how),
  );
  return opened === true;
}

async function asEntry([sha256, blob]: readonly [string, Blob]): Promise<FileEntry> {
  return {
    path: sha256,
    size: blob.size,
    head: new Uint8Array(await blob.slice(0, headSize).arrayBuffer()),
    sha256,
    bytes: async () => new Uint8Array(await blob.arrayBuffer()),
  };
}

function tooLate(milliseconds: number): Promise<never> {
  return new Promise((_, reject) => {
    setTimeout(() => reject(new Error('the database does not answer')), milliseconds);
  });
}
