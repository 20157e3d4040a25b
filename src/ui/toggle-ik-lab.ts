import type { Editor } from './editor.ts';

/** A section that is shown for the first time is loaded; so many frames it may take. */
const mostFrames = 300;

/** Closes the IK lab, or opens it, scrolls to it, and moves the keyboard focus there. */
export async function toggleIkLab({ session, tab, drawer }: Editor): Promise<void> {
  const { showIkLab } = session;
  showIkLab.value = !showIkLab.value || tab.value !== 'pose';
  if (!showIkLab.value) return;
  tab.value = 'pose';
  drawer.value = 'right';
  const find = () => document.querySelector<HTMLElement>('.ik-lab[open] > :nth-child(2)');
  for (let frame = 0; find() === null && frame < mostFrames; frame++) {
    await new Promise(requestAnimationFrame);
  }
  const summary = document.querySelector<HTMLElement>('.ik-lab > summary');
  summary?.scrollIntoView({ block: 'start' });
  summary?.focus({ preventScroll: true });
}
