import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { readObj } from '../../../src/formats/obj/read-obj.ts';
import { shown } from '../../support/diagnose.ts';
import { decimalText } from '../../support/decimals.ts';
import { bytesOf } from '../../support/files.ts';

async function read(text: string) {
  const { value, diagnostics } = await readObj('a.obj', bytesOf(text));
  return { value, messages: shown(diagnostics) };
}

const blank = fc.constantFrom(' ', ' ', ' ', '  ', '\t', ' \t');
const number = fc.oneof(
  { weight: 6, arbitrary: fc.integer({ min: -99, max: 99 }).map((n) => `${n / 8}`) },
  { weight: 2, arbitrary: decimalText },
  fc.constantFrom('nan', 'x', '1e39', '-.5', '5.', '1e', '1e5', '+2', '1,5', '0'.repeat(70)),
);
const index = fc.oneof(
  { weight: 8, arbitrary: fc.integer({ min: 1, max: 4 }).map(String) },
  { weight: 2, arbitrary: fc.integer({ min: -6, max: 9 }).map(String) },
  fc.constantFrom('', '+1', '1.0', '01', 'x', '4294967297', '0000000001'),
);
const corner = fc.oneof(
  { weight: 4, arbitrary: index },
  ...[2, 3, 4].map((most) =>
    fc.array(index, { minLength: 2, maxLength: most }).map((fields) => fields.join('/')),
  ),
);

function line(keyword: string, token: fc.Arbitrary<string>, most: number): fc.Arbitrary<string> {
  const tokens = fc.array(fc.tuple(blank, token), { minLength: 1, maxLength: most });
  return fc
    .tuple(fc.constantFrom('', '', '', ' ', '\t'), tokens, fc.constantFrom('', '', ' ', '\t '))
    .map(([before, parts, after]) => `${before}${keyword}${parts.flat().join('')}${after}`);
}

const lines = fc.array(
  fc.oneof(
    line('v', number, 7),
    line('vt', number, 4),
    line('vn', number, 4),
    { weight: 3, arbitrary: line('f', corner, 6) },
    fc.constantFrom('', 'g a', 's 1', 'l 1 2', 'vx 1', 'v', 'f'),
  ),
  { maxLength: 12 },
);
const square = ['v 0 0 0', 'v 1 0 0', 'v 1 1 0', 'v 0 1 0', 'vt 0 1', 'vn 0 0 1', 'f 1 2 3'];

describe('plain lines of an OBJ', () => {
  it('are read as by the careful reader, to which comments leave them', async () => {
    await fc.assert(
      fc.asyncProperty(lines, fc.constantFrom('\n', '\r\n'), async (some, lineEnd) => {
        const all = [...square, ...some];
        const quick = await read(all.map((each) => each + lineEnd).join(''));
        const careful = await read(all.map((each) => `${each} #${lineEnd}`).join(''));
        expect(quick).toEqual(careful);
      }),
      { numRuns: 500 },
    );
  });

  it('end in a line feed, a carriage return before it, or with the file', async () => {
    const expected = await read(`${square.join('\n')}\n`);
    expect(expected.messages).toEqual([]);
    for (const lineEnd of ['\n', '\r\n', '\r\r\n', '\r']) {
      expect(await read(square.join(lineEnd) + lineEnd), JSON.stringify(lineEnd)).toEqual(expected);
      expect(await read(square.join(lineEnd)), JSON.stringify(lineEnd)).toEqual(expected);
    }
  });

  it('are counted, so that a later message names its line', async () => {
    const { messages } = await read(`${square.join('\r\n')}\n\nf 1 2 9\nv 0 0 0\n`);
    expect(messages[0]).toContain('a.obj:9:7: expected 1 to 4 or -4 to -1, found "9"');
  });

  it('are read to the last of a face with many corners', async () => {
    const count = 100;
    const around = Array.from({ length: count }, (_, i) => {
      const angle = (i / count) * 2 * Math.PI;
      return `v ${Math.cos(angle)} ${Math.sin(angle)} 0\n`;
    });
    const corners = Array.from({ length: count }, (_, i) => i + 1);
    const { value } = await read(`${around.join('')}f ${corners.join(' ')}\n`);
    expect(value?.cornerPoints).toHaveLength((count - 2) * 3);
  });
});
