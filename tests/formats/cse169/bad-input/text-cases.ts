import { expect } from 'vitest';
import { legSkel } from '../../../support/cse169-files.ts';
import { bytesOf } from '../../../support/files.ts';
import { type BadInput, meshOnly, noSkel, readSkeleton, whole } from './bad-input.ts';

const skipped = 'it is skipped, with its numbers or its block';

/** The complete leg, with any line ends, and the two words that no reader knows. */
function sameLeg(title: string, text: string, at: readonly [string, string]): BadInput {
  const unknown = ['mass', 'joint'].map(
    (word, i) =>
      `:${at[i]!}: expected a word of this format, found "${word}" [skel/unknown]; ${skipped}`,
  );
  return readSkeleton(`B26 ${title}`, text, unknown, 3, ({ skeleton }) => {
    expect(skeleton.names).toEqual(['hip', 'knee', 'foot']);
    expect([...skeleton.parents]).toEqual([-1, 0, 1]);
    [0, 1, 0, 0, -0.5, 0, 0, -0.5, 0.1].forEach((value, i) =>
      expect(skeleton.restOffsets[i]).toBeCloseTo(value, 12),
    );
  });
}

function notText(title: string, content: string | Uint8Array, message: string): BadInput {
  return {
    title,
    files: { ...whole, 'a.skel': content },
    messages: [`error: a.skel: expected ${message}; the file is not used`],
    left: meshOnly,
  };
}

const spaces = ' '.repeat(10 * 1024 * 1024);
/** "# Größe" in the encoding of Windows. */
const latin1 = Uint8Array.of(...bytesOf('balljoint a { }\n# Gr'), 0xf6, 0xdf, 0x65, 0x0a);
const invalid =
  'expected UTF-8 text, found "byte 0xF6" [file/encoding]; such characters are shown as \uFFFD; all else is read';

/** B1, B31, B32 and B34: encodings and kinds of files; B26: line ends. */
export const textCases: readonly BadInput[] = [
  notText('B1 empty file', '', '.skel text, found "an empty file" [file/empty]'),
  noSkel(
    'B1 nothing but a comment',
    '# balljoint\n',
    ':2:1: expected "balljoint", found "no joint" [skel/empty]',
  ),
  sameLeg('lines that end with CRLF', legSkel.replaceAll('\n', '\r\n'), ['8:3', '9:3']),
  sameLeg('lines that end with CR CR LF', legSkel.replaceAll('\n', '\r\r\n'), ['8:3', '9:3']),
  sameLeg('lines that end with CR', legSkel.replaceAll('\n', '\r'), ['8:3', '9:3']),
  sameLeg('blank lines, no line end at the end', legSkel.replaceAll('\n', '\n\n').trimEnd(), [
    '15:3',
    '17:3',
  ]),
  readSkeleton("B31 the other course's .skel", '0 0 0 -1\n0 1 0 0\n', [], 2, ({ missing }) =>
    expect(missing).toEqual(['.obj', '.attach']),
  ),
  notText(
    'B32 UTF-16, low byte first',
    Uint8Array.of(0xff, 0xfe, 0x7b, 0),
    'UTF-8 text, found "a UTF-16 byte order mark" [file/encoding]',
  ),
  notText(
    'B32 UTF-16, high byte first',
    Uint8Array.of(0xfe, 0xff, 0, 0x7b),
    'UTF-8 text, found "a UTF-16 byte order mark" [file/encoding]',
  ),
  notText(
    'B32 NUL byte',
    'balljoint a {\0}',
    '.skel text, found "byte 0x00 @ byte 13" [file/binary]',
  ),
  notText(
    'B32 web page',
    '<!DOCTYPE html>\n<script>{}</script>\n',
    '.skel text, found "an HTML page" [file/html]',
  ),
  readSkeleton('B32 Latin-1 in a comment', latin1, [`:2:5: ${invalid}`]),
  {
    title: 'B32 Latin-1 in a name of a .skin',
    files: {
      ...whole,
      'a.skin': Uint8Array.of(
        ...bytesOf(`${whole['a.skin'] as string}material h`),
        ...[0xf6, 0x20, 0x7b, 0x7d],
      ),
    },
    messages: [`warning: a.skin:6:11: ${invalid}`],
    left: { ...meshOnly, joints: 1, bound: true },
  },
  noSkel(
    'B34 10 MiB of spaces',
    `//{\n${spaces}`,
    `:2:${spaces.length + 1}: expected "balljoint", found "no joint" [skel/empty]`,
  ),
  readSkeleton('B34 10 MiB of spaces on the line of a joint', `balljoint a {${spaces}}`, []),
];
