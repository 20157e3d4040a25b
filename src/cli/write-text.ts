import { writeFileSync } from 'node:fs';
import { printDiagnostics, unwritable, userPath } from './files.ts';

/** Writes a file of text, or prints why it can't be written and returns false. */
export function writeText(path: string, text: string): boolean {
  try {
    writeFileSync(userPath(path), text);
    return true;
  } catch (error) {
    printDiagnostics([unwritable(path, error)]);
    return false;
  }
}
