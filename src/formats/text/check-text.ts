import type { DiagnosticCode, DiagnosticLog } from '../../core/diagnostics.ts';
import { extensionOf } from '../file-entry.ts';
import { hasZero } from './byte-words.ts';
import { decodeText } from './decode-text.ts';
import { isLfsPointer, lfsPointer } from './lfs-pointer.ts';

/**
 * Returns the bytes of a text file without its byte order mark. Returns nothing, with a diagnostic,
 * if they are not text: UTF-16, a renamed picture, a server's error page, a pointer to the file,
 * rich text, or an empty file.
 */
export function checkText(
  file: string,
  bytes: Uint8Array,
  log: DiagnosticLog,
): Uint8Array | undefined {
  const fault = faultOf(bytes);
  if (fault) {
    const expected = fault.expected ?? `${extensionOf(file)} text`.trim();
    log.error({ code: fault.code, expected, found: fault.found, effect: 'the file is not used' });
    return undefined;
  }
  return hasByteOrderMark(bytes) ? bytes.subarray(3) : bytes;
}

interface Fault {
  readonly code: DiagnosticCode;
  readonly found: string;
  /** Absent if the file only has to be text. */
  readonly expected?: string;
}

function faultOf(bytes: Uint8Array): Fault | undefined {
  if (bytes.length === 0) return { code: 'file/empty', found: 'an empty file' };
  if ((bytes[0] === 0xff && bytes[1] === 0xfe) || (bytes[0] === 0xfe && bytes[1] === 0xff)) {
    const found = 'a UTF-16 byte order mark';
    return { code: 'file/encoding', found, expected: 'UTF-8 text' };
  }
  if (hasZero(bytes)) {
    return { code: 'file/binary', found: `byte 0x00 @ byte ${bytes.indexOf(0)}` };
  }
  if (isLfsPointer(bytes)) return lfsPointer;
  const start = decodeText(bytes.subarray(0, 64));
  if (start.startsWith('{\\rtf')) {
    const expected = 'plain text; save it as such';
    return { code: 'file/rich-text', found: 'rich text (RTF) of a word processor', expected };
  }
  return isWebPage(bytes) ? { code: 'file/html', found: 'an HTML page' } : undefined;
}

function isWebPage(bytes: Uint8Array): boolean {
  const start = decodeText(bytes.subarray(0, 256));
  return /^\s*<(!doctype|!--|\?xml|html|head|body|title|script)/i.test(start);
}

function hasByteOrderMark(bytes: Uint8Array): boolean {
  return bytes[0] === 0xef && bytes[1] === 0xbb && bytes[2] === 0xbf;
}
