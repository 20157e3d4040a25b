import type { Editor } from './editor.ts';

/** A section that is shown for the first time is loaded; so many frames it may take. */
const mostFrames = 300;

/** Shows the field for a vertex's number, and moves the keyboard focus there. */
export async function focusVertexField({ tab, drawer }: Editor): Promise<void> {
  tab.value = 'deform';
  drawer.value = 'right';
  const find = () => document.querySelector<HTMLElement>('.controls .vertex-number');
  for (let frame = 0; find() === null && frame < mostFrames; frame++) {
    await new Promise(requestAnimationFrame);
  }
  find()?.focus();
}
