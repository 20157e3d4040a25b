import type { FileEntry } from '../formats/format.ts';
import { fileEntry } from './file-entry.ts';

/**
 * Asks for files with the browser's dialog.
 * @param extensions what to offer; null asks for a folder
 */
export function chooseFiles(
  extensions: readonly string[] | null,
  then: (files: readonly FileEntry[]) => void,
): void {
  const input = document.createElement('input');
  input.type = 'file';
  input.multiple = true;
  if (extensions) input.accept = extensions.join(',');
  else input.webkitdirectory = true;
  input.addEventListener('change', () => {
    void Promise.all(Array.from(input.files ?? [], (file) => fileEntry(file))).then(then);
  });
  input.click();
}
