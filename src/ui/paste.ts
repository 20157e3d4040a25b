import { loadPart } from '../core/failure.ts';
import { memoryFile } from '../formats/file-entry.ts';
import type { FileEntry } from '../formats/format.ts';
import { attempt } from './attempt.ts';
import type { Opening } from './editor.ts';

/** Opens pasted files, or a pose as text, as if they were chosen. */
export function listenToPaste(opening: Pick<Opening, 'openFiles' | 'notice'>): void {
  window.addEventListener('paste', (event) => {
    if (event.target instanceof HTMLInputElement) return;
    const files = Array.from(event.clipboardData?.files ?? []);
    const text = event.clipboardData?.getData('text/plain').trim() ?? '';
    if (files.length > 0) {
      attempt(opening, opening.openFiles(list(files), 'ask'));
    } else if (text.startsWith('{')) {
      const bytes = new TextEncoder().encode(text);
      attempt(opening, opening.openFiles([memoryFile('pasted pose.json', bytes)]));
    }
  });
}

async function list(files: readonly File[]): Promise<readonly FileEntry[]> {
  const { fileEntry } = await loadPart(import('./file-entry.ts'));
  return Promise.all(files.map((file) => fileEntry(file)));
}
