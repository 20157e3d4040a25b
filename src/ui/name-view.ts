import { effect } from '@preact/signals-core';
import { printable } from '../core/diagnostics.ts';
import { selectedActor } from '../document/selected-actor.ts';
import type { Looking } from './editor.ts';

/** Gives the view an accessible name and description: what it shows, and how to operate it. */
export function nameView(canvas: HTMLCanvasElement, { store, session }: Looking): void {
  canvas.setAttribute(
    'aria-description',
    'Arrow keys orbit, Home frames all, brackets select joints, a question mark shows all keys',
  );
  effect(() => {
    const { length } = store.scene.value.actors;
    const actor = selectedActor(store, session);
    const joint = session.selectedJoint.value;
    const shown = actor ? printable(actor.name, 80) : 'nothing';
    const name = [
      `3D view: ${shown}`,
      ...(actor && joint !== null ? [printable(actor.character.skeleton.names[joint]!, 40)] : []),
      ...(length > 1 ? [`one of ${length} characters`] : []),
    ];
    canvas.setAttribute('aria-label', name.join(', '));
  });
}
