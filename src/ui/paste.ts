import { memoryFile } from '../formats/file-entry.ts';
import type { Opening } from './editor.ts';
import { fileEntry } from './file-entry.ts';

/** Pasted files, or a pose as text, open as if they were dropped. */
export function listenToPaste({ openFiles }: Pick<Opening, 'openFiles'>): void {
  window.addEventListener('paste', (event) => {
    if (event.target instanceof HTMLInputElement) return;
    const files = Array.from(event.clipboardData?.files ?? []);
    const text = event.clipboardData?.getData('text/plain').trim() ?? '';
    if (files.length > 0) {
      void Promise.all(files.map((file) => fileEntry(file))).then((entries) => openFiles(entries));
    } else if (text.startsWith('{')) {
      const bytes = new TextEncoder().encode(text);
      void openFiles([memoryFile('pasted pose.json', bytes)]);
    }
  });
}
