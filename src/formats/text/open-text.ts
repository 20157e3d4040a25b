import type { DiagnosticLog } from '../../core/diagnostics.ts';
import { checkText } from './check-text.ts';
import { LineReader, type LineOptions } from './line-reader.ts';

/** A reader of a file's lines, or nothing (and a diagnostic) where the file is no text. */
export function openText(
  file: string,
  bytes: Uint8Array,
  log: DiagnosticLog,
  options: LineOptions,
): LineReader | undefined {
  const text = checkText(file, bytes, log);
  return text && new LineReader(text, log, options);
}
