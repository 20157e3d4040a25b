import { readFileSync } from 'node:fs';
import path from 'node:path';
import { root } from '../../tools/commands.mjs';
import { lastRow } from './ledger.ts';
import { tableOf } from './table.ts';

export const performanceFile = 'docs/performance.md';

const [begin, end] = ['<!-- the table begins -->', '<!-- the table ends -->'];

/** The page with the table of the newest row of the ledger. */
export function performancePage(): string[] {
  const text = readFileSync(path.join(root, performanceFile), 'utf8');
  const [from, to] = [text.indexOf(begin) + begin.length, text.indexOf(end)];
  const row = lastRow();
  const table = row ? tableOf(row) : 'Nothing is measured yet.';
  return [`${text.slice(0, from)}\n\n${table}\n\n${text.slice(to)}`];
}
