import type { Gesture, Store } from '../document/store.ts';

/** The gesture to which a key that is held adds its steps. */
let held: Gesture | null = null;

/**
 * Returns the gesture of a key that is held, which is committed when the key is released, so that
 * all of its steps are one step of undo.
 */
export function heldGesture(store: Store, label: string): Gesture {
  if (!held?.isOpen) {
    const gesture = store.begin(label);
    held = gesture;
    window.addEventListener('keyup', () => gesture.commit(), { once: true });
  }
  return held;
}
