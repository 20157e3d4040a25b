import { expect, it } from 'vitest';
import { writeCsv } from '../../../src/formats/csv/write-csv.ts';

it('writes texts, numbers and empty cells, a line for each row', () => {
  const rows = [
    ['name', 'x'],
    ['a, "b"\nc', -1.5],
    ['é', null],
    ['', 1e-7],
  ];
  expect(writeCsv(rows)).toBe('name,x\n"a, ""b""\nc",-1.5\né,\n,1e-7\n');
  expect(writeCsv([])).toBe('');
});

it('leaves numbers out that are none', () => {
  expect(writeCsv([[NaN, Infinity, 0]])).toBe(',,0\n');
});

it('keeps a spreadsheet from taking a name for a formula', () => {
  expect(writeCsv([['=1+1', '@x', '-y', '+', 'a=b']])).toBe("'=1+1,'@x,'-y,'+,a=b\n");
  expect(writeCsv([['=A1,"x"']])).toBe('"\'=A1,""x"""\n');
});
