import type { Store } from './store.ts';

/**
 * Whether the scene is as the first visit found it: no step can be undone or redone, and every
 * character is bundled. What is opened then replaces the whole scene, since nobody made it.
 */
export function isUntouched({ scene, undoLabel, redoLabel }: Store): boolean {
  if (undoLabel.value !== null || redoLabel.value !== null) return false;
  return scene.value.actors.every(({ source }) => source.kind === 'bundled');
}
