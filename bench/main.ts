/**
 * `npm run bench` measures Sinew and its peers in one run. docs/performance.md says how; `--only`
 * chooses groups, and an unknown word shows all options.
 */
import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { cacheFolder, root } from '../tools/commands.mjs';
import { install } from '../tools/install.mjs';
import { writeDocs } from '../tools/write-docs.ts';
import { type GroupId, goals } from './goals.ts';
import { whatGotWorse } from './harness/compare.ts';
import type { GroupResult } from './harness/group.ts';
import { lastRow, type Run, saveRow, textOf } from './harness/ledger.ts';
import { describeMachine, loadAverage } from './harness/machine.ts';
import { plotOf } from './harness/plot.ts';
import { startGroup } from './harness/start-group.ts';
import { leastWall } from './harness/statistics.ts';
import { rowOf } from './harness/table.ts';
import { type BenchWords, parseWords } from './options.ts';

const plotFile = 'docs/pictures/cost.svg';

try {
  const words = parseWords(process.argv.slice(2));
  install(path.join(root, 'bench'));
  const worse = await main(words);
  for (const line of worse) console.error(`worse than the last row: ${line}`);
  process.exitCode = worse.length > 0 ? 1 : 0;
} catch (error) {
  console.error(error instanceof Error ? error.message : error);
  process.exitCode = 1;
}

/** Returns what got worse since the last row, if that was asked for. */
async function main({ long, check, only, rounds, save, testSeconds }: BenchWords) {
  const before = loadAverage();
  const found: Partial<Record<GroupId, GroupResult>> = {};
  const worse: string[] = [];
  for (const id of only) {
    const run = (rounds: number) => startGroup(id, { long, rounds });
    const began = performance.now();
    let result = await run(rounds);
    const row = check ? lastRow()?.groups[id] : undefined;
    // A busy machine explains more than a change does, so a loss must show twice.
    if (row && whatGotWorse(result, row).length > 0) result = await run(2 * rounds);
    if (row) worse.push(...whatGotWorse(result, row));
    found[id] = result;
    show(id, result, (performance.now() - began) / 1000);
  }
  const run: Run = {
    date: new Date().toISOString().slice(0, 10),
    machine: describeMachine(),
    load: [before, loadAverage()],
    rounds,
    testSeconds,
    groups: found,
  };
  const folder = path.join(cacheFolder, 'bench');
  mkdirSync(folder, { recursive: true });
  writeFileSync(path.join(folder, 'last-run.json'), textOf(run));
  const { curves } = found.scaling ?? {};
  if (curves) writeFileSync(path.join(root, plotFile), plotOf(curves));
  if (save !== null) {
    saveRow(save, run);
    await writeDocs();
  }
  return worse;
}

function show(id: GroupId, { values, samples, counts }: GroupResult, seconds: number): void {
  console.log(`\n${id} (${seconds.toFixed(0)} s)`);
  for (const [contender, taken] of Object.entries(samples)) {
    console.log(`  ${leastWall(taken).toPrecision(4).padStart(9)} ms at least  ${contender}`);
  }
  for (const [name, count] of Object.entries(counts)) console.log(`  ${name}: ${count}`);
  for (const goal of goals) if (values[goal.id]) console.log(`  ${rowOf(goal, values[goal.id])}`);
}
