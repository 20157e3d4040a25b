import { goals } from '../goals.ts';
import type { GroupResult } from './group.ts';

/** How much worse a value may be than in the ledger: paired ratios differ by 1.3 between runs. */
const margin = 1.4;
/** Bytes do not depend on the machine. */
const sizeMargin = 1.05;

/** Describes each value of a group that is clearly worse than before. */
export function whatGotWorse(now: GroupResult, before: GroupResult): string[] {
  return goals.flatMap(({ id, contender, good, unit }) => {
    const [value, old] = [now.values[id]?.value, before.values[id]?.value];
    if (value === undefined || old === undefined) return [];
    const allowed = unit === '×' || unit === 'ms' ? margin : sizeMargin;
    const isWorse = good === 'high' ? value * allowed < old : value > old * allowed;
    if (!isWorse) return [];
    return [`${contender}: ${format(value)} ${unit}, was ${format(old)} ${unit}`];
  });
}

function format(value: number): string {
  return String(Number(value.toPrecision(3)));
}
