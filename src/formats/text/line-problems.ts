import type { DiagnosticLog, Place } from '../../core/diagnostics.ts';
import { firstInvalidByte } from './decode-text.ts';

/**
 * Whether a line is not UTF-8, and a warning if so. Not an error: old tools write comments and names
 * in the encodings of their time, and the numbers are ASCII in all of them.
 */
export function reportEncoding(log: DiagnosticLog, place: Place, line: Uint8Array): boolean {
  const invalid = firstInvalidByte(line);
  if (invalid === -1) return false;
  log.warn({
    code: 'file/encoding',
    ...place,
    column: invalid + 1,
    expected: 'UTF-8 text',
    found: `byte 0x${line[invalid]!.toString(16).toUpperCase()}`,
    effect: 'such characters are shown as \uFFFD; all else is read',
  });
  return true;
}

export function reportLength(log: DiagnosticLog, place: Place, found: number, most: number): void {
  log.error({
    code: 'file/limit',
    ...place,
    expected: `a line of at most ${most} bytes`,
    found: `${found}`,
    effect: 'the file is not used',
  });
}

/** For a last line that is to be continued. */
export function reportOpenEnd(log: DiagnosticLog, place: Place): void {
  log.warn({
    code: 'file/continuation',
    ...place,
    expected: 'a line after one that ends in \\',
    found: 'the end of the file',
    effect: 'the line is read as it stands',
  });
}
