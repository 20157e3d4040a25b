import { compareWith } from '../evaluation/comparison/compare.ts';
import { comparisonRows, type NamedNumbers } from '../evaluation/comparison/comparison-rows.ts';
import { sizeOf } from '../evaluation/comparison/difference.ts';
import { rowSumsOf } from '../evaluation/comparison/row-sums.ts';
import { Evaluator } from '../evaluation/evaluator.ts';
import { writeCsv } from '../formats/csv/write-csv.ts';
import type { Command } from './command.ts';
import { comparedActor, preparedPool } from './compared-actor.ts';
import { comparedOptions, comparedUsage } from './compared-options.ts';
import { comparisonLines } from './comparison-lines.ts';
import { writeText } from './write-text.ts';

/**
 * `compare FILES [--pose POSE]` prints how far apart skinning methods put the points of a pose, and
 * what volume each leaves. `--csv` also has the distance of every point.
 */
export const compare: Command = {
  name: 'compare',
  usage: `compare FILES ${comparedUsage}`,
  summary:
    'Compares skinning methods in one pose of one character: how far each puts the points from where the base does, at most and in the mean, and its volume against that at rest. The base is the first method, if --base names none. A volume is that of the closed parts of the mesh of at least 1 % of its area; without any it is "–". Where rows of weights don\'t sum to 1, the part that is due to this is printed too, and --normalize divides them by their sums. --set, which may be repeated, sets a parameter of a method, such as blend=0.5. The CSV has the same numbers and the distance of every point.',
  async run(words) {
    const options = comparedOptions(words);
    const { methods, base, csv } = options;
    const actor = await comparedActor(options);
    if (!actor) return 1;
    const pool = await preparedPool(actor, methods);
    const evaluations = methods.map(({ id: method }) => {
      const state = { ...actor, method };
      return new Evaluator(state, pool).evaluate(state, 0);
    });
    const numbers = compareWith(evaluations[methods.indexOf(base)]!, evaluations);
    const named = numbers.map((each, i): NamedNumbers => ({ name: methods[i]!.short, ...each }));
    const size = sizeOf(actor.character);
    if (csv !== undefined && !writeText(csv, writeCsv(comparisonRows(size, named)))) return 1;
    const sums = rowSumsOf(evaluations[0]!.skin);
    console.log(comparisonLines(named, base.short, size, sums).join('\n'));
    return 0;
  },
};
