import type { Store } from '../document/store.ts';
import type { Editor } from './editor.ts';

/** Whether anything can be undone or redone. */
export function hasSteps({ undoLabel, redoLabel }: Store): boolean {
  return undoLabel.value !== null || redoLabel.value !== null;
}

/**
 * Takes a step of the history, shows its name, and frames characters that are new or in other
 * units. A character that was opened again keeps its name, so the camera stays.
 *
 * @param take returns the name of the step, or null if there is none
 */
export function takeStep(editor: Editor, verb: string, take: () => string | null): void {
  const { store, notice } = editor;
  const shown = (): string =>
    store.scene.value.actors.map(({ character, fitted }) => `${character.name} ${fitted}`).join();
  const before = shown();
  const label = take();
  if (label === null) return;
  if (shown() !== before) editor.frameOpened();
  const text = `${verb}: ${label}`;
  // Screen readers announce changes only, so a repeated text differs by a blank.
  notice.value = notice.value === text ? `${text}\u00a0` : text;
}
