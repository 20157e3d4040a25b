import { Failure } from '../../core/failure.ts';
import type { EarlierScene } from '../../ui/editor.ts';
import { listKept } from './kept-scenes.ts';
import { whyRefused } from './open-given-scene.ts';
import { openKept } from './restore-scene.ts';
import { openScenes } from './scene-locks.ts';
import type { SceneParts } from './scene-parts.ts';

/** The scenes that this browser keeps and no page has open, the last changed first. */
export async function listEarlier(): Promise<readonly EarlierScene[]> {
  try {
    const [listed, isOpen] = [await listKept(), await openScenes()];
    return listed.filter(({ id }) => !isOpen(id));
  } catch {
    return []; // it keeps nothing
  }
}

/** Opens a scene that was kept, whose record this page then goes on with. */
export async function openEarlier(parts: SceneParts, id: string): Promise<void> {
  const kept = (await listKept()).find((each) => each.id === id);
  if (!kept) throw new Failure('This browser does not keep that scene any more');
  const opened = await openKept(parts, kept, id);
  if (!opened) parts.opening.notice.value = `The scene could not be opened: ${whyRefused(parts)}`;
}
