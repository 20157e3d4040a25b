import { memoryFile } from '../formats/file-entry.ts';
import { attempt } from './attempt.ts';
import type { Opening } from './editor.ts';
import { fileEntry } from './file-entry.ts';

/** Pasted files, or a pose as text, open as if they were dropped. */
export function listenToPaste(opening: Pick<Opening, 'openFiles' | 'notice'>): void {
  window.addEventListener('paste', (event) => {
    if (event.target instanceof HTMLInputElement) return;
    const files = Array.from(event.clipboardData?.files ?? []);
    const text = event.clipboardData?.getData('text/plain').trim() ?? '';
    if (files.length > 0) {
      const entries = Promise.all(files.map((file) => fileEntry(file)));
      attempt(opening, entries.then(opening.openFiles));
    } else if (text.startsWith('{')) {
      const bytes = new TextEncoder().encode(text);
      attempt(opening, opening.openFiles([memoryFile('pasted pose.json', bytes)]));
    }
  });
}
