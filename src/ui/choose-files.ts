import { attempt } from './attempt.ts';
import type { Opening } from './editor.ts';
import { fileEntry } from './file-entry.ts';

/**
 * Opens the browser's file dialog, and then the files that the user chooses.
 *
 * @param extensions offered by the dialog; null asks for a folder
 * @param add keeps the other characters; otherwise the user is asked where there is a choice
 */
export function chooseFiles(
  editor: Pick<Opening, 'openFiles' | 'notice'>,
  extensions: readonly string[] | null,
  add: true | 'ask' = 'ask',
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
