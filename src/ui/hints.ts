import { effect, type ReadonlySignal, signal } from '@preact/signals-core';
import type { Gallery, Looking } from './editor.ts';
import { keepValue, keptValue } from './kept.ts';

/** What a first visit does not know yet, and the place where it is said. */
export interface Hint {
  readonly id: 'look' | 'pose' | 'drop';
  readonly place: 'view' | 'outliner';
  readonly text: string;
}

/** Every hint; each place shows the first that is left, until it was followed once. */
const hints: readonly Hint[] = [
  { id: 'look', place: 'view', text: 'Drag to look around' },
  { id: 'pose', place: 'view', text: 'Click a limb, then drag it' },
  { id: 'drop', place: 'outliner', text: 'Drop your files anywhere' },
];

const key = 'hints followed';

/** The hints that are left for this visitor. They go when what they say was done, and stay away. */
export function createHints(
  canvas: HTMLCanvasElement,
  { store, viewer, own }: Looking & Gallery,
): ReadonlySignal<readonly Hint[]> {
  const followed = keptValue(key).split(' ');
  const left = signal(hints.filter(({ id }) => !followed.includes(id)));
  const follow = (done: Hint['id']): void => {
    if (!left.value.some(({ id }) => id === done)) return;
    left.value = left.value.filter(({ id }) => id !== done);
    const rest = hints.filter((hint) => !left.value.includes(hint));
    keepValue(key, rest.map(({ id }) => id).join(' '));
  };
  let camera = viewer.camera.peek();
  let scene = store.scene.peek();
  canvas.addEventListener('pointerdown', () => {
    camera = viewer.camera.peek();
    scene = store.scene.peek();
  });
  canvas.addEventListener('pointerup', () => {
    if (viewer.camera.peek() !== camera) follow('look');
    if (store.scene.peek() !== scene) follow('pose');
  });
  effect(() => {
    if (own.value.length > 0) follow('drop');
  });
  return left;
}

export function hintAt(left: readonly Hint[], place: Hint['place']): Hint | undefined {
  return left.find((hint) => hint.place === place);
}
