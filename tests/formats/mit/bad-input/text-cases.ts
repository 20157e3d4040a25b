import { expect } from 'vitest';
import type { Character } from '../../../../src/core/character.ts';
import { bytesOf } from '../../../support/files.ts';
import { all, type BadInput, meshOnly, unbound, whole, withObj, withSkel } from './bad-input.ts';

const skel = whole['a.skel'] as string;

function sameSkeleton(title: string, text: string): BadInput {
  return {
    title,
    files: withSkel(text),
    messages: [],
    left: all,
    check({ skeleton }: Character) {
      expect([...skeleton.parents]).toEqual([-1, 0, 1]);
      expect([...skeleton.restOffsets]).toEqual([0, 0, 0, 0, 1, 0, 0, 1, 0]);
    },
  };
}

function refused(title: string, content: string | Uint8Array, message: string): BadInput {
  return { title, files: withSkel(content), messages: [`error: a.skel${message}`], left: meshOnly };
}

const page = '<!DOCTYPE html>\n<html><head><title>404</title></head></html>\n';
const pngHead = Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0, 0, 0, 0x0d);
/** "# Größe" in the encoding of Windows. */
const latin1 = Uint8Array.of(0x23, 0x20, 0x47, 0x72, 0xf6, 0xdf, 0x65, 0x0a, ...bytesOf(skel));

/**
 * A21 to A23, A25, A27 and A68: encodings and kinds of text files, the same for all three formats.
 */
export const textCases: readonly BadInput[] = [
  sameSkeleton('A21 byte order mark', `\uFEFF${skel}`),
  sameSkeleton('A21 CRLF', skel.replaceAll('\n', '\r\n')),
  sameSkeleton('A21 CR CR LF', skel.replaceAll('\n', '\r\r\n')),
  sameSkeleton('A21 CR alone', skel.replaceAll('\n', '\r')),
  sameSkeleton('A21 tabs', skel.replaceAll(' ', '\t')),
  sameSkeleton('A21 no line end at the end', skel.trimEnd()),
  refused(
    'A22 UTF-16, low byte first',
    Uint8Array.of(0xff, 0xfe, 0x30, 0),
    ': expected UTF-8 text, found "a UTF-16 byte order mark" [file/encoding]',
  ),
  refused(
    'A22 UTF-16, high byte first',
    Uint8Array.of(0xfe, 0xff, 0, 0x30),
    ': expected UTF-8 text, found "a UTF-16 byte order mark" [file/encoding]',
  ),
  {
    title: 'A22 Latin-1 in a comment',
    files: withSkel(latin1),
    messages: ['warning: a.skel:1:5: expected UTF-8 text, found "byte 0xF6" [file/encoding]'],
    left: all,
  },
  refused(
    'A23 NUL byte',
    '0 0 0 -1\n0 1\0 0 0\n',
    ': expected .skel text, found "byte 0x00 @ byte 12" [file/binary]',
  ),
  refused(
    'A23 PNG renamed',
    pngHead,
    ': expected .skel text, found "byte 0x00 @ byte 8" [file/binary]',
  ),
  refused(
    'A25 line past the limit',
    `0 0 0 -1\n0 0 0 0 #${'x'.repeat(1024 * 1024)}\n`,
    ':2: expected a line of at most 1048576 bytes, found "1048585" [file/limit]',
  ),
  {
    title: 'A25 line at the limit',
    files: withSkel(`${skel}#${'x'.repeat(1024 * 1024 - 1)}\n`),
    messages: [],
    left: all,
  },
  refused(
    'A25 number of 100,000 digits',
    `${'1'.repeat(100_000)} 0 0 -1\n`,
    `:1:1: expected a number of at most 64 characters for x, found "${'1'.repeat(40)}…" [skel/limit]`,
  ),
  {
    title: 'A25 number at the limit',
    files: withSkel(skel.replace('0 1 0 0', `0 ${'1'.padStart(64, '0')} 0 0`)),
    messages: [],
    left: all,
  },
  {
    title: "A27 the other course's .skel",
    files: { 'a.skel': 'balljoint root {\n  offset 0 0 0\n}\n' },
    messages: [],
    left: { ...all, joints: 1, vertices: 0, triangles: 0, bound: false },
  },
  ...(['.skel', '.obj', '.attach'] as const).map((kind): BadInput => ({
    title: `A68 web page as ${kind}`,
    files: { ...whole, [`a${kind}`]: page },
    messages: [`error: a${kind}: expected ${kind} text, found "an HTML page" [file/html]`],
    left: {
      '.skel': meshOnly,
      '.obj': { ...all, vertices: 0, triangles: 0, bound: false },
      '.attach': unbound,
    }[kind],
  })),
  {
    title: 'A68 web page that begins with a comment',
    files: withObj(`\n<!-- generated -->\n${page}`),
    messages: ['error: a.obj: expected .obj text, found "an HTML page" [file/html]'],
    left: { ...all, vertices: 0, triangles: 0, bound: false },
  },
];
