import type { FileEntry } from '../formats/format.ts';
import { attempt } from './attempt.ts';
import { droppedFiles } from './dropped-files.ts';
import type { Opening } from './editor.ts';

/** The whole window takes dropped files; an outline says so while some are held over it. */
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
    if (!event.dataTransfer) return;
    attempt(opening, open(droppedFiles(event.dataTransfer)));
  });

  async function open(dropped: Promise<readonly FileEntry[]>): Promise<void> {
    const files = await dropped;
    if (files.length > 0) await opening.openFiles(files);
  }
}
