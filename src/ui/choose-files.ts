import { attempt } from './attempt.ts';
import type { Opening } from './editor.ts';
import { fileEntry } from './file-entry.ts';

/**
 * Asks for files with the browser's dialog, and opens what is chosen.
 *
 * @param extensions what to offer; null asks for a folder
 * @param add beside the others; else in the place of the selected one
 */
export function chooseFiles(
  editor: Pick<Opening, 'openFiles' | 'notice'>,
  extensions: readonly string[] | null,
  add = false,
): void {
  const input = document.createElement('input');
  input.type = 'file';
  input.multiple = true;
  if (extensions) input.accept = extensions.join(',');
  else input.webkitdirectory = true;
  input.addEventListener('change', () => {
    const entries = Promise.all(Array.from(input.files ?? [], (file) => fileEntry(file)));
    attempt(editor, editor.openFiles(entries, add));
  });
  input.click();
}
