import { compareWith } from '../evaluation/comparison/compare.ts';
import { comparisonRows, type NamedNumbers } from '../evaluation/comparison/comparison-rows.ts';
import { sizeOf } from '../evaluation/comparison/difference.ts';
import { rowSumsOf } from '../evaluation/comparison/row-sums.ts';
import type { Evaluation } from '../evaluation/evaluation.ts';
import { writeCsv } from '../formats/csv/write-csv.ts';
import type { Command } from './command.ts';
import { comparedOptions, comparedUsage } from './compared-options.ts';
import { comparisonLines } from './comparison-lines.ts';
import { givenSettings } from './method-settings.ts';
import { createPool, plainCharacter, posedEvaluation } from './posed-evaluation.ts';
import { readPosed } from './read-posed.ts';
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
    const { files, pose, methods, base, set, normalize, csv } = comparedOptions(words);
    const methodSettings = await givenSettings(methods, set);
    const posed = await readPosed(files, pose);
    if (!posed) return 1;
    const pool = await createPool();
    const character = plainCharacter(posed.character);
    const kept = { ...posed.pose, normalizeWeights: normalize, methodSettings };
    const evaluations: Evaluation[] = [];
    for (const { id } of methods) {
      evaluations.push(await posedEvaluation(pool, character, id, kept));
    }
    const numbers = compareWith(evaluations[methods.indexOf(base)]!, evaluations);
    const named = numbers.map((each, i): NamedNumbers => ({ name: methods[i]!.short, ...each }));
    const size = sizeOf(character);
    if (csv !== undefined && !writeText(csv, writeCsv(comparisonRows(size, named)))) return 1;
    const sums = rowSumsOf(evaluations[0]!.skin);
    console.log(comparisonLines(named, base.short, size, sums).join('\n'));
    return 0;
  },
};
