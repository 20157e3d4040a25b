import { printable } from '../core/diagnostics.ts';
import { loadPart } from '../core/failure.ts';
import { selectedActor } from '../document/selected-actor.ts';
import { isUntouched } from '../document/untouched.ts';
import type { FileEntry } from '../formats/format.ts';
import { attempt } from './attempt.ts';
import type { Opening } from './editor.ts';

/** A part of the view on which files can be dropped. */
interface Half {
  readonly label: string;
  readonly add: boolean;
}

type DropTarget = Pick<Opening, 'openFiles' | 'notice' | 'store' | 'session'>;

/**
 * Accepts files that are dropped anywhere in the window. Meanwhile the view shows what a drop on
 * its left and on its right half does, with the half under the pointer lit.
 */
export function listenToDrops(opening: DropTarget, view: HTMLElement): void {
  const zone = document.body.appendChild(document.createElement('div'));
  zone.className = 'drop-zone';
  zone.popover = 'manual'; // over an open dialog, too
  let depth = 0;
  let halves: readonly Half[] = [];
  const hide = (): void => {
    depth = 0;
    if (zone.matches(':popover-open')) zone.hidePopover();
  };
  const halfAt = (x: number): number => {
    const { left, width } = view.getBoundingClientRect();
    return halves.length === 2 && x >= left + width / 2 ? 1 : 0;
  };
  const light = ({ clientX }: DragEvent): void => {
    const lit = halfAt(clientX);
    for (const [index, each] of Array.from(zone.children).entries()) {
      each.classList.toggle('lit', index === lit);
    }
  };

  window.addEventListener('dragenter', (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    depth++;
    if (depth > 1) {
      light(event);
      return;
    }
    halves = halvesFor(opening, event);
    const { left, top, width, height } = view.getBoundingClientRect();
    const box = { left, top, width, height };
    for (const [side, length] of Object.entries(box)) zone.style.setProperty(side, `${length}px`);
    zone.replaceChildren(...halves.map(({ label }) => halfElement(label)));
    light(event);
    zone.showPopover();
  });
  window.addEventListener('dragleave', () => {
    depth = Math.max(0, depth - 1);
    if (depth === 0) hide();
  });
  window.addEventListener('dragover', (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    light(event);
  });
  window.addEventListener('drop', (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    const { add } = halves[halfAt(event.clientX)] ?? { add: false };
    hide();
    const { dataTransfer } = event;
    if (!dataTransfer) return;
    // Both lists are emptied after the event, so they are read before any await.
    const files = Array.from(dataTransfer.files);
    const entries = Array.from(dataTransfer.items, (item) => item.webkitGetAsEntry());
    attempt(opening, opening.openFiles(list(files, entries), add));
  });
}

function hasFiles({ dataTransfer }: DragEvent): boolean {
  return dataTransfer?.types.includes('Files') === true;
}

/**
 * A drop replaces a scene that nobody touched; poses and pictures go to the selected character.
 * Otherwise there is a choice.
 */
function halvesFor({ store, session }: DropTarget, { dataTransfer }: DragEvent): readonly Half[] {
  const selected = selectedActor(store, session);
  const types = Array.from(dataTransfer?.items ?? [], ({ type }) => type);
  // Some browsers tell the types with the drop only.
  const isForSelected =
    types.length > 0 && types.every((type) => /^(image\/|application\/json$)/.test(type));
  if (!selected || isUntouched(store) || isForSelected) {
    return [{ label: 'Drop to open', add: false }];
  }
  return [
    { label: `Replace ${printable(selected.character.name, 60)}`, add: false },
    { label: 'Add', add: true },
  ];
}

function halfElement(label: string): HTMLElement {
  const half = document.createElement('div');
  half.textContent = label;
  return half;
}

async function list(
  files: readonly File[],
  entries: readonly (FileSystemEntry | null)[],
): Promise<readonly FileEntry[]> {
  const { droppedFiles } = await loadPart(import('./dropped-files.ts'));
  return droppedFiles(files, entries);
}
