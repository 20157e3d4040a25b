import { loadPart } from '../core/failure.ts';
import type { FileEntry } from '../formats/format.ts';
import { attempt } from './attempt.ts';
import type { DropHalves } from './drop-halves.ts';
import type { Looking, Opening } from './editor.ts';

export type DropTarget = Looking & Pick<Opening, 'openFiles' | 'notice'>;

/**
 * Accepts files that are dropped anywhere in the window. What the view shows meanwhile is loaded with
 * the first drag, because the first picture does not wait for it.
 */
export function listenToDrops(target: DropTarget, view: HTMLElement): void {
  let depth = 0;
  let halves: DropHalves | undefined;
  let loading = false;
  const loadHalves = async (): Promise<void> => {
    loading = true;
    const loaded = await loadPart(import('./drop-halves.ts'));
    halves = new loaded.DropHalves(target, view);
  };
  const follow = ({ dataTransfer, clientX }: DragEvent): void => {
    const types = Array.from(dataTransfer?.items ?? [], ({ type }) => type);
    const show = (): void => {
      if (depth > 0) halves?.follow(types, clientX);
    };
    if (loading) show();
    else attempt(target, loadHalves().then(show));
  };

  window.addEventListener('dragenter', (event) => {
    event.preventDefault();
    depth++;
    if (hasFiles(event)) follow(event);
  });
  window.addEventListener('dragleave', () => {
    depth = Math.max(0, depth - 1);
    if (depth === 0) halves?.hide();
  });
  window.addEventListener('dragover', (event) => {
    event.preventDefault();
    depth = Math.max(depth, 1); // elements that vanish during the drag are never left
    if (hasFiles(event)) follow(event);
  });
  window.addEventListener('drop', (event) => {
    event.preventDefault();
    const add = halves?.addsAt(event.clientX) === true;
    halves?.selectUnder(event);
    depth = 0;
    halves?.hide();
    const { dataTransfer } = event;
    if (!dataTransfer) return;
    // Both lists are emptied after the event, so they are read before any await.
    const files = Array.from(dataTransfer.files);
    const entries = Array.from(dataTransfer.items, (item) => item.webkitGetAsEntry());
    if (files.length === 0 && entries.every((entry) => entry === null)) return;
    const handles = handlesOf(dataTransfer.items);
    attempt(target, target.openFiles(list(files, entries), add, handles));
  });
}

function hasFiles({ dataTransfer }: DragEvent): boolean {
  return dataTransfer?.types.includes('Files') === true;
}

/** By which the browser finds the files at a later visit; only some browsers give them. */
async function handlesOf(items: DataTransferItemList): Promise<readonly FileSystemHandle[]> {
  const given = Array.from(items, async (item) => item.getAsFileSystemHandle?.());
  const settled = await Promise.allSettled(given);
  return settled.flatMap((each) => (each.status === 'fulfilled' && each.value) || []);
}

async function list(
  files: readonly File[],
  entries: readonly (FileSystemEntry | null)[],
): Promise<readonly FileEntry[]> {
  const { droppedFiles } = await loadPart(import('./dropped-files.ts'));
  return droppedFiles(files, entries);
}
