import type { Store } from './store.ts';

/**
 * Whether the scene is as the first visit found it: no step can be undone or redone, every character
 * is bundled, and no scene came that somebody made. What is opened then replaces the whole scene,
 * since nobody made it.
 */
export function isUntouched({ scene, isMade, undoLabel, redoLabel }: Store): boolean {
  if (isMade.value) return false;
  if (undoLabel.value !== null || redoLabel.value !== null) return false;
  return scene.value.actors.every(({ source }) => source.kind === 'bundled');
}
