import { memoryFile } from '../formats/file-entry.ts';
import type { Editor } from './editor.ts';
import { fileEntry } from './file-entry.ts';

/** Pasted files, or a pose as text, open as if they were dropped. */
export function listenToPaste(editor: Editor): void {
  window.addEventListener('paste', (event) => {
    if (event.target instanceof HTMLInputElement) return;
    const files = Array.from(event.clipboardData?.files ?? []);
    const text = event.clipboardData?.getData('text/plain').trim() ?? '';
    if (files.length > 0) {
      void Promise.all(files.map((file) => fileEntry(file))).then((entries) =>
        editor.openFiles(entries),
      );
    } else if (text.startsWith('{')) {
      const bytes = new TextEncoder().encode(text);
      void editor.openFiles([memoryFile('pasted pose.json', bytes)]);
    }
  });
}
