import { loadPart } from '../core/failure.ts';
import type { FileEntry } from '../formats/format.ts';
import { attempt } from './attempt.ts';
import type { Opening } from './editor.ts';

/** Accepts files that are dropped anywhere in the window; an outline is shown during the drag. */
export function listenToDrops(opening: Pick<Opening, 'openFiles' | 'notice'>): void {
  let depth = 0;
  const setOver = (over: boolean): void => {
    document.body.classList.toggle('drop-over', over);
  };
  window.addEventListener('dragenter', (event) => {
    event.preventDefault();
    depth++;
    setOver(true);
  });
  window.addEventListener('dragleave', () => {
    depth = Math.max(0, depth - 1);
    if (depth === 0) setOver(false);
  });
  window.addEventListener('dragover', (event) => event.preventDefault());
  window.addEventListener('drop', (event) => {
    event.preventDefault();
    depth = 0;
    setOver(false);
    const { dataTransfer } = event;
    if (!dataTransfer) return;
    // Both lists are emptied after the event, so they are read before any await.
    const files = Array.from(dataTransfer.files);
    const entries = Array.from(dataTransfer.items, (item) => item.webkitGetAsEntry());
    const hasFiles = files.length > 0 || entries.some((entry) => entry !== null);
    if (hasFiles) attempt(opening, opening.openFiles(list(files, entries)));
  });
}

async function list(
  files: readonly File[],
  entries: readonly (FileSystemEntry | null)[],
): Promise<readonly FileEntry[]> {
  const { droppedFiles } = await loadPart(import('./dropped-files.ts'));
  return droppedFiles(files, entries);
}
