import { describe, expect, it } from 'vitest';
import { DiagnosticLog } from '../../../src/core/diagnostics.ts';
import { BinaryReader } from '../../../src/formats/binary/binary-reader.ts';
import { shown } from '../../support/diagnose.ts';

const codes = { truncated: 'pmd/truncated', count: 'pmd/count' } as const;

function readerOf(...bytes: readonly number[]) {
  const log = new DiagnosticLog('a');
  const file = Uint8Array.of(9, ...bytes).subarray(1); // does not start at the start of its buffer
  return { log, reader: new BinaryReader(file, log, codes, 'not used') };
}

describe('BinaryReader', () => {
  it('reads little-endian numbers, one record after another', () => {
    const { reader, log } = readerOf(7, 0, 0x34, 0x12, 0, 0, 0x80, 0xbf, 0xff);
    expect(reader.integer(2, 'a')).toBe(7);
    const record = reader.record(6, 'b')!;
    expect([record.offset, record.u16(0), record.f32(2), record.u8(5)]).toEqual([
      2, 0x1234, -1, 0xbf,
    ]);
    expect([...record.bytes(4, 2)]).toEqual([0x80, 0xbf]);
    expect([reader.offset, reader.left]).toEqual([8, 1]);
    expect(reader.integer(1, 'c')).toBe(255);
    expect(log.diagnostics).toEqual([]);
  });

  it('reads a count and as many records', () => {
    const { reader } = readerOf(2, 1, 0, 2, 0);
    const { count, offset, records } = reader.array(1, 2, 'words')!;
    expect([count, offset, records.u16(0), records.u16(2), reader.left]).toEqual([2, 0, 1, 2, 0]);
  });

  it.each([
    [[0xff, 0xff, 0xff, 0xff], 38, 4294967295],
    [[0x06, 0x28, 0x6b, 0x06], 40, 107685894],
    [[1, 0, 0, 0], 2, 1],
  ])('refuses more records than there are bytes for: %j of %i', (count, size, found) => {
    const { reader, log } = readerOf(...count, 5);
    expect(reader.array(4, size, 'things')).toBeUndefined();
    expect(shown(log.diagnostics)).toEqual([
      `error: a @ byte 0 (0x0): expected at most 0 things of ${size} bytes in the 1 bytes left, ` +
        `found "${found}" [pmd/count]; not used`,
    ]);
  });

  it('reports what is cut off, as a warning if the file is usable without it', () => {
    const { reader, log } = readerOf(1, 2, 3);
    expect(reader.record(4, 'a number')).toBeUndefined();
    expect(reader.left).toBe(3);
    reader.beLenient('it goes on');
    expect(reader.integer(4, 'another')).toBeUndefined();
    expect(shown(log.diagnostics)).toEqual([
      'error: a @ byte 0 (0x0): expected 4 bytes for a number, found "3 bytes" [pmd/truncated]; ' +
        'not used',
      'warning: a @ byte 0 (0x0): expected 4 bytes for another, found "3 bytes" [pmd/truncated]; ' +
        'it goes on',
    ]);
  });
});
