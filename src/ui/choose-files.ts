import type { FileEntry } from '../formats/format.ts';
import { fileEntry } from './file-entry.ts';

/** Asks for files with the browser's dialog. */
export function chooseFiles(
  extensions: readonly string[],
  then: (files: readonly FileEntry[]) => void,
): void {
  const input = document.createElement('input');
  input.type = 'file';
  input.multiple = true;
  input.accept = extensions.join(',');
  input.addEventListener('change', () => {
    void Promise.all(Array.from(input.files ?? [], fileEntry)).then(then);
  });
  input.click();
}
