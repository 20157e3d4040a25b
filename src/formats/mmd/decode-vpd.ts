import type { DiagnosticLog } from '../../core/diagnostics.ts';
import { decodeText, firstInvalidByte } from '../text/decode-text.ts';

/** Bytes from here on begin three bytes of UTF-8, as all Japanese characters have. */
const threeBytes = 0xe0;

/**
 * Decodes the text of a pose, which is in Shift-JIS. A text that is valid UTF-8 with characters of
 * three bytes, as none in Shift-JIS is by accident, or that starts with a byte order mark, is read
 * as UTF-8, with a warning, because MikuMikuDance does not read it.
 */
export function decodeVpd(bytes: Uint8Array, hasMark: boolean, log: DiagnosticLog): string {
  const isUtf8 =
    hasMark || (bytes.some((byte) => byte >= threeBytes) && firstInvalidByte(bytes) < 0);
  if (isUtf8) {
    const found = hasMark ? 'a UTF-8 byte order mark' : 'UTF-8';
    const effect = 'read as UTF-8';
    log.warn({ code: 'vpd/encoding', line: 1, expected: 'Shift-JIS text', found, effect });
    return decodeText(bytes);
  }
  const text = new TextDecoder('shift_jis').decode(bytes);
  const broken = text.indexOf('\uFFFD');
  if (broken >= 0) {
    const line = text.slice(0, broken).split(/\r*\n|\r/).length;
    const found = 'bytes that are no characters';
    const effect = 'names that have them may not be found';
    log.warn({ code: 'vpd/encoding', line, expected: 'Shift-JIS text', found, effect });
  }
  return text;
}
