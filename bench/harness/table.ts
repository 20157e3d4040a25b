import { type Goal, goals } from '../goals.ts';
import { limits } from '../limits.ts';
import type { Value } from './group.ts';
import type { Run } from './ledger.ts';

/** The table of docs/performance.md, with a line on where it was measured. */
export function tableOf(run: Run): string {
  const values: Readonly<Record<string, Value>> = Object.assign(
    {},
    ...Object.values(run.groups).map((group) => group.values),
  ) as Record<string, Value>;
  const rows = goals.map((goal) => rowOf(goal, values[goal.id]));
  return [
    measuredOn(run),
    '',
    '| | against | now | must | aim | |',
    '| --- | --- | --- | --- | --- | --- |',
    ...rows,
  ].join('\n');
}

/** One line of the table; the last cell says what limits a value that misses its aim. */
export function rowOf(goal: Goal, found: Value | undefined): string {
  const sign = goal.good === 'high' ? '≥' : '≤';
  const now = found ? valueText(goal, found) : '–';
  const reaches = (bound: number): boolean =>
    found !== undefined && (goal.good === 'high' ? found.value >= bound : found.value <= bound);
  const verdict = !found
    ? 'not measured'
    : reaches(goal.aim)
      ? 'aim reached'
      : `${reaches(goal.must) ? 'must reached' : 'must missed'}: ${limits[goal.id] ?? ''}`;
  const bounds = [goal.must, goal.aim].map((bound) => `${sign} ${bound}${space(goal)}`);
  return `| ${[goal.contender, goal.against, now, ...bounds, verdict].join(' | ')} |`;
}

function valueText(goal: Goal, { value, lower, upper, cpu }: Value): string {
  const quartiles =
    lower === undefined || upper === undefined ? '' : ` (${short(lower)}–${short(upper)})`;
  const byCpu = cpu === undefined ? '' : `, ${short(cpu)}× by processor time`;
  return `${short(value)}${space(goal)}${quartiles}${byCpu}`;
}

function measuredOn({ date, machine, load, rounds }: Run): string {
  const { node, browser, three } = machine.versions;
  return [
    `Measured on ${date}, with ${machine.cores} cores of ${machine.processor},`,
    `${machine.memoryGiB} GiB, ${machine.system}, Node ${node}, ${browser}, three.js ${three},`,
    `a load average of ${short(load[0])} before and ${short(load[1])} after, ${rounds} rounds.`,
  ].join('\n');
}

function space({ unit }: Goal): string {
  return unit === '×' ? unit : ` ${unit}`;
}

function short(value: number): string {
  return value >= 100 ? String(Math.round(value)) : String(Number(value.toPrecision(2)));
}
