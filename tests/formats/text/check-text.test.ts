import { describe, expect, it } from 'vitest';
import { DiagnosticLog } from '../../../src/core/diagnostics.ts';
import { checkText } from '../../../src/formats/text/check-text.ts';
import { shown } from '../../support/diagnose.ts';
import { bytesOf, textOf } from '../../support/files.ts';

function check(content: string | Uint8Array) {
  const log = new DiagnosticLog('a.obj');
  const text = checkText('a.obj', bytesOf(content), log);
  return { text: text && textOf(text), messages: shown(log.diagnostics) };
}

describe('checkText', () => {
  it('returns text without its byte order mark', () => {
    expect(check('\uFEFFv 1 2 3')).toEqual({ text: 'v 1 2 3', messages: [] });
    expect(check('< 3').messages).toEqual([]);
  });

  it.each([
    ['an empty file', '', 'expected .obj text, found "an empty file" [file/empty]'],
    [
      'UTF-16, low byte first',
      Uint8Array.of(0xff, 0xfe, 0x76, 0),
      'expected UTF-8 text, found "a UTF-16 byte order mark" [file/encoding]',
    ],
    [
      'UTF-16, high byte first',
      Uint8Array.of(0xfe, 0xff, 0, 0x76),
      'expected UTF-8 text, found "a UTF-16 byte order mark" [file/encoding]',
    ],
    [
      'a picture',
      Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0, 0),
      'expected .obj text, found "byte 0x00 @ byte 8" [file/binary]',
    ],
    [
      "a server's error page",
      '\n<!doctype html><html>',
      'expected .obj text, found "an HTML page" [file/html]',
    ],
    ['a web page', '<HTML lang="en">', 'expected .obj text, found "an HTML page" [file/html]'],
  ])('refuses %s', (_, content, message) => {
    expect(check(content)).toEqual({
      text: undefined,
      messages: [`error: a.obj: ${message}; the file is not used`],
    });
  });
});
