import { parseArgs } from 'node:util';
import { printable } from '../core/diagnostics.ts';
import type { Character } from '../core/character.ts';
import { sweepOf, type Sweep } from '../evaluation/comparison/sweep.ts';
import { sweepRows } from '../evaluation/comparison/sweep-rows.ts';
import { type TurnRange, turnRanges } from '../evaluation/comparison/turn-range.ts';
import { writeCsv } from '../formats/csv/write-csv.ts';
import { findJoint } from '../formats/pose-json.ts';
import { aligned } from './aligned.ts';
import type { Command } from './command.ts';
import { comparedActor, finished, preparedPool } from './compared-actor.ts';
import { methodNames, methodsNamed } from './named-methods.ts';
import { joinValue, parseWords } from './parse-words.ts';
import { UsageError } from './usage-error.ts';
import { writeText } from './write-text.ts';

const axisNames = ['x', 'y', 'z'] as const;
const defaultSteps = 36;
const mostSteps = 3600;

/** `sweep FILES --joint NAME --axis x` prints volume and cross-section over the range of an axis. */
export const sweep: Command = {
  name: 'sweep',
  usage: `sweep FILES --joint NAME|#N --axis x|y|z [--steps N] [--pose POSE.json|POSE.vpd] [--methods ${methodNames.join(',')}] [--set NAME=VALUE] [--normalize] [--csv OUT.csv]`,
  summary: `Turns a joint of one character about one axis over its range (its limits, or half a turn each way) in ${defaultSteps} steps or as many as --steps says, and prints what skinning methods do to the volume and to the cross-section, as parts of those at rest. The section is the outline of the skin that the plane through the joint, perpendicular to its bone, cuts at rest; it moves with the skin, and its area is measured. "–" is printed where the mesh encloses no volume or the joint is not inside it. --set, which may be repeated, sets a parameter of a method, such as blend=0.5.`,
  async run(words) {
    const options = parseOptions(words);
    const actor = await comparedActor(options);
    if (!actor) return 1;
    const range = rangeOf(actor.character, options.joint, options.axis);
    const ids = options.methods.map(({ id }) => id);
    const pool = await preparedPool(actor, options.methods);
    const swept = finished(sweepOf(pool, actor, ids, range, options.steps));
    const { csv } = options;
    if (csv !== undefined && !writeText(csv, writeCsv(sweepRows(swept)))) return 1;
    console.log(sweepLines(swept).join('\n'));
    return 0;
  },
};

function sweepLines(result: Sweep): string[] {
  const [head, ...rows] = sweepRows(result);
  const percent = (part: string | number | null): string =>
    part === null ? '–' : `${(100 * Number(part)).toFixed(1)} %`;
  const shown = rows.map(([angle, ...parts]) => {
    return [`${Number(Number(angle).toFixed(2))}°`, ...parts.map(percent)];
  });
  return aligned([head!.map((name) => String(name).replace(' / rest', '')), ...shown]);
}

function rangeOf({ skeleton }: Character, name: string, axis: 0 | 1 | 2): TurnRange {
  const joint = findJoint(skeleton, name);
  if (typeof joint === 'string') throw new UsageError(`expected ${joint}, found "${name}"`);
  const ranges = turnRanges(skeleton, joint);
  const range = ranges.find((each) => each.axis === axis);
  if (range) return range;
  const can = ranges.map((each) => axisNames[each.axis]).join('|');
  const expected = can === '' ? 'a joint that can turn' : `--axis ${can}`;
  const found = can === '' ? printable(name, 80) : axisNames[axis];
  throw new UsageError(`expected ${expected}, found "${found}"`);
}

function parseOptions(words: readonly string[]) {
  const { values, positionals: files } = parseWords(() =>
    parseArgs({
      args: joinValue(words, '--steps'),
      options: {
        joint: { type: 'string' },
        axis: { type: 'string' },
        steps: { type: 'string' },
        pose: { type: 'string' },
        methods: { type: 'string' },
        set: { type: 'string', multiple: true, default: [] },
        normalize: { type: 'boolean', default: false },
        csv: { type: 'string' },
      },
      allowPositionals: true,
    }),
  );
  const { joint, pose, set, normalize, csv } = values;
  if (files.length === 0) throw new UsageError('expected files, found none');
  if (joint === undefined) throw new UsageError('expected --joint with a name or #N');
  const axis = axisNames.indexOf(values.axis as 'x') as 0 | 1 | 2 | -1;
  if (axis < 0) throw new UsageError(`expected --axis x|y|z, found "${values.axis ?? 'none'}"`);
  const steps = values.steps === undefined ? defaultSteps : Number(values.steps);
  if (!(Number.isInteger(steps) && steps >= 1 && steps <= mostSteps)) {
    throw new UsageError(`expected --steps from 1 to ${mostSteps}, found "${values.steps}"`);
  }
  const methods = methodsNamed('--methods', values.methods);
  return { files, joint, axis: axis as 0 | 1 | 2, steps, pose, methods, set, normalize, csv };
}
