import type { DiagnosticLog } from '../../core/diagnostics.ts';
import { checkText } from './check-text.ts';
import { LineReader, type LineOptions } from './line-reader.ts';

/** Returns a reader of a file's lines, or nothing, with a diagnostic, if the file is not text. */
export function openText(
  file: string,
  bytes: Uint8Array,
  log: DiagnosticLog,
  options: LineOptions,
): LineReader | undefined {
  const text = checkText(file, bytes, log);
  return text && new LineReader(text, log, options);
}
