import type { DiagnosticLog } from '../../core/diagnostics.ts';

const effect = 'the file is not used';

/**
 * The bytes of a text file without a byte order mark, or nothing (and a diagnostic) where they are
 * no UTF-8 text: UTF-16, a picture that was renamed, a server's error page, an empty file.
 */
export function checkText(bytes: Uint8Array, log: DiagnosticLog): Uint8Array | undefined {
  if (bytes.length === 0) {
    log.error({ code: 'file/empty', expected: 'text', found: 'an empty file', effect });
    return undefined;
  }
  if ((bytes[0] === 0xff && bytes[1] === 0xfe) || (bytes[0] === 0xfe && bytes[1] === 0xff)) {
    const found = 'a UTF-16 byte order mark';
    log.error({ code: 'file/encoding', expected: 'UTF-8 text', found, effect });
    return undefined;
  }
  const nul = bytes.indexOf(0);
  if (nul >= 0) {
    const found = `byte 0x00 @ byte ${nul}`;
    log.error({ code: 'file/binary', expected: 'text', found, effect });
    return undefined;
  }
  const text = hasByteOrderMark(bytes) ? bytes.subarray(3) : bytes;
  if (/^\s*<(!doctype|html|head|\?xml)/i.test(decodeText(text.subarray(0, 256)))) {
    log.error({ code: 'file/html', expected: 'the file itself', found: 'a web page', effect });
    return undefined;
  }
  return text;
}

const decoder = new TextDecoder();

export function decodeText(bytes: Uint8Array): string {
  return decoder.decode(bytes);
}

function hasByteOrderMark(bytes: Uint8Array): boolean {
  return bytes[0] === 0xef && bytes[1] === 0xbb && bytes[2] === 0xbf;
}
