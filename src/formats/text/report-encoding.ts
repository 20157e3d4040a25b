import type { DiagnosticLog } from '../../core/diagnostics.ts';
import { isAscii } from './byte-words.ts';
import { decodeText } from './decode-text.ts';
import { carriageReturn, endOfLineEnd, lineFeed } from './line-ends.ts';
import { reportEncoding } from './line-problems.ts';

const beyondAscii = 0x80;
const longestSource = 160;

/** Warns about the first line that is not UTF-8, in a text that is not read line by line. */
export function reportTextEncoding(log: DiagnosticLog, bytes: Uint8Array): void {
  if (isAscii(bytes)) return;
  let line = 1;
  let start = 0;
  while (start < bytes.length) {
    let end = start;
    let bits = 0;
    for (; end < bytes.length; end++) {
      const byte = bytes[end]!;
      if (byte === lineFeed || byte === carriageReturn) break;
      bits |= byte;
    }
    if (bits >= beyondAscii) {
      const text = bytes.subarray(start, end);
      const source = decodeText(text.subarray(0, longestSource));
      if (reportEncoding(log, { line, source }, text)) return;
    }
    start = endOfLineEnd(bytes, end);
    line++;
  }
}
