import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import type { GroupId } from '../goals.ts';
import type { GroupResult } from './group.ts';
import type { Machine } from './machine.ts';

/** A run of the bench. One is kept for each milestone, as a row of the ledger bench/results. */
export interface Run {
  readonly date: string;
  readonly machine: Machine;
  /** The load average before and after. */
  readonly load: readonly [start: number, end: number];
  readonly rounds: number;
  /** The seconds that `npm test` took, if they were given. */
  readonly testSeconds: number | null;
  readonly groups: Readonly<Partial<Record<GroupId, GroupResult>>>;
}

const folder = path.join(import.meta.dirname, '../results');

/** Returns the newest row of the ledger. Rows are named by their milestones, which count up. */
export function lastRow(): Run | undefined {
  const names = readdirSync(folder).filter((name) => name.endsWith('.json'));
  const last = names.sort((a, b) => a.localeCompare(b, 'en', { numeric: true })).at(-1);
  return last === undefined
    ? undefined
    : (JSON.parse(readFileSync(path.join(folder, last), 'utf8')) as Run);
}

export function saveRow(name: string, run: Run): void {
  writeFileSync(path.join(folder, `${name}.json`), textOf(run));
}

/** JSON with samples of four digits and one contender per line. */
export function textOf(run: Run): string {
  const short = (_: string, value: unknown): unknown =>
    typeof value === 'number' && !Number.isInteger(value) ? Number(value.toPrecision(4)) : value;
  const lines = JSON.stringify(run, short, 2);
  // A sample needs no line for each of its numbers.
  return `${lines.replace(/\{\s+"wall"[^{}]*\}/g, (sample) => sample.replace(/\s+/g, ' '))}\n`;
}
