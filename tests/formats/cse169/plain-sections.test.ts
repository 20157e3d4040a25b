import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { readSkin } from '../../../src/formats/cse169/skin.ts';
import { shown } from '../../support/diagnose.ts';
import { bytesOf } from '../../support/files.ts';

/** The tokens of a file and the line ends between them. */
const square = [
  ...['positions', '4', '{', '\n', '0', '0', '0', '\n', '1', '0', '0', '1', '1', '0', '\n'],
  ...['0', '.5e1', '-0.25', '}', '\n', 'normals', '4', '{', '0', '0', '1', '\n', '0', '0', '1'],
  ...['0', '0', '1', '0', '0', '1', '\n', '}', 'texcoords', '4', '{', '0', '0', '1', '0', '\n'],
  ...['1', '1', '0', '1', '}', '\n', 'skinweights', '4', '{', '\n', '1', '0', '1', '\n', '2'],
  ...['0', '.5', '1', '.5', '1', '1', '1', '\n', '1', '0', '1', '}', '\n', 'triangles', '2'],
  ...['{', '\n', '0', '1', '2', '\n', '0', '2', '3', '\n', '}', 'bindings', '2', '{'],
  ...['matrix', '{', '1', '0', '0', '0', '1', '0', '0', '0', '1', '0', '0', '0', '}'],
  ...['matrix', '{', '1', '0', '0', '0', '1', '0', '0', '0', '1', '0', '1', '0', '}', '}', '\n'],
];

const odd = fc.constantFrom(
  ...['0', '1', '2', '3', '4', '9', '-1', '+1', '1.0', '1e0', 'nan', 'x', '{', '}', '\n', '\r\n'],
  ...['1e19', '2e6', '1e400', '0'.repeat(65), '12345678901', '0.12345678901234567', '# 1\n'],
);

const changes = fc.array(fc.tuple(fc.nat(square.length - 1), odd, fc.nat(2)), { maxLength: 4 });

/** The tokens with some of them replaced, taken out, or preceded by others. */
function changed(list: readonly (readonly [number, string, number])[]): string[] {
  const tokens = [...square];
  for (const [at, token, removed] of list) tokens.splice(at, Math.min(removed, 1), token);
  return tokens;
}

/** Room, so that no count is too large for a file only because it has no comments. */
const room = `\n${' '.repeat(2000)}`;

/** The value and the messages, without columns and without the room in the file. */
function read(text: string) {
  const { value, diagnostics } = readSkin('a.skin', bytesOf(text + room));
  return {
    value,
    messages: shown(diagnostics).map((each) =>
      each.replace(/(:\d+):\d+:/, '$1:').replace(/at most \d+ (?=.*no room)/, ''),
    ),
  };
}

describe('plain sections of a .skin', () => {
  it('are valid as they are', () => {
    const { value, messages } = read(square.join(' '));
    expect(messages).toEqual([]);
    expect(value?.skin?.lines).toEqual(Uint32Array.of(10, 11, 11, 12));
    expect(value?.skin?.joints).toEqual(Uint16Array.of(0, 0, 1, 1, 0));
    expect(value?.mesh.cornerPoints).toEqual(Uint32Array.of(0, 1, 2, 0, 2, 3));
  });

  it('are read as by the careful reader, to which comments leave them', () => {
    fc.assert(
      fc.property(changes, fc.constantFrom(' ', '\t', '  '), (list, blank) => {
        const tokens = changed(list);
        expect(read(tokens.join(blank))).toEqual(read(tokens.join(' /**/ ')));
      }),
      { numRuns: 500 },
    );
  });
});
