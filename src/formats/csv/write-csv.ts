import { writeFloat64 } from '../text/write-number.ts';

/** A cell of a table: a text, a number, or nothing. */
export type Cell = string | number | null;

/** A text that begins so would be a formula for a spreadsheet. */
const formulaStart = /^[=+\-@\t\r]/;
const special = /[",\r\n]/;

/**
 * Writes a table as comma-separated values (RFC 4180, with line feeds): a dot in numbers, whatever the
 * place of the reader, and texts in quotation marks where they need them. A text that a spreadsheet
 * would take for a formula gets an apostrophe before it.
 */
export function writeCsv(rows: Iterable<readonly Cell[]>): string {
  const lines: string[] = [];
  for (const row of rows) lines.push(`${row.map(cellText).join(',')}\n`);
  return lines.join('');
}

function cellText(cell: Cell): string {
  if (cell === null) return '';
  if (typeof cell === 'number') return Number.isFinite(cell) ? writeFloat64(cell) : '';
  const text = formulaStart.test(cell) ? `'${cell}` : cell;
  return special.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
