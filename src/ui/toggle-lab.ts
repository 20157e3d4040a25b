import type { Signal } from '@preact/signals-core';
import type { Editor } from './editor.ts';
import type { TabId } from './tabs.ts';

/** A section that is shown for the first time is loaded; so many frames it may take. */
const mostFrames = 300;

/**
 * Closes a lab, or opens it in its tab, scrolls to it, and moves the keyboard focus there.
 *
 * @param name the class of its section
 */
export async function toggleLab(
  editor: Editor,
  isOpen: Signal<boolean>,
  home: TabId,
  name: string,
): Promise<void> {
  isOpen.value = !isOpen.value || editor.tab.value !== home;
  if (isOpen.value) await goToSection(editor, home, name);
}

/** Goes to the tab of an open section, scrolls to it, and moves the keyboard focus there. */
export async function goToSection(
  { tab, drawer }: Pick<Editor, 'tab' | 'drawer'>,
  home: TabId,
  name: string,
): Promise<void> {
  tab.value = home;
  drawer.value = 'right';
  const find = () => document.querySelector<HTMLElement>(`.${name}[open] > :nth-child(2)`);
  for (let frame = 0; find() === null && frame < mostFrames; frame++) {
    await new Promise(requestAnimationFrame);
  }
  const summary = document.querySelector<HTMLElement>(`.${name} > summary`);
  summary?.scrollIntoView({ block: 'start' });
  summary?.focus({ preventScroll: true });
}
