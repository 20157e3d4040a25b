import type { Skeleton } from '../core/skeleton.ts';
import { skinInUse } from '../document/scene.ts';
import { stressOf, type StressSuite } from '../evaluation/comparison/stress.ts';
import { stressPoses, usualRanges } from '../evaluation/comparison/stress-poses.ts';
import { stressLabel, stressRows } from '../evaluation/comparison/stress-rows.ts';
import { rounded } from '../evaluation/truncation.ts';
import { writeCsv } from '../formats/csv/write-csv.ts';
import { aligned } from './aligned.ts';
import type { Command } from './command.ts';
import { comparedActor, finished, preparedPool } from './compared-actor.ts';
import { comparedOptions, comparedUsage } from './compared-options.ts';
import { UsageError } from './usage-error.ts';
import { writeText } from './write-text.ts';

const degree = Math.PI / 180;
const [bend, twist] = [usualRanges.bend, usualRanges.twist].map((range) =>
  Math.round(range / degree),
);

/** `stress FILES` compares methods in the extremes of every joint. */
export const stress: Command = {
  name: 'stress',
  usage: `stress FILES [--bend DEGREES] [--twist DEGREES] ${comparedUsage}`,
  summary: `Compares skinning methods in a stress suite: each joint of one character that deforms its mesh, one at a time, turned to both ends of its range, from the file's pose or from that of --pose. A hinge with limits has these for its range. A joint that turns freely bends about two axes across its bone by --bend (${bend} if absent) and twists about it by --twist (${twist}), each way; the joints of a body turn no farther than such joints do. Prints for each pose how far a method puts the points from where the base does, at most and in the mean, and the volume against that at rest. The other options are those of compare.`,
  async run(words) {
    const options = comparedOptions(words, ['bend', 'twist']);
    const { methods, base, csv, further } = options;
    const ranges = {
      bend: angleOf('--bend', further['bend'], usualRanges.bend),
      twist: angleOf('--twist', further['twist'], usualRanges.twist),
    };
    const actor = await comparedActor(options);
    if (!actor) return 1;
    const { skeleton } = actor.character;
    const poses = stressPoses(actor.character, skinInUse(actor), actor.q, ranges);
    const ids = methods.map(({ id }) => id);
    const pool = await preparedPool(actor, methods);
    const suite = finished(stressOf(pool, actor, ids, methods.indexOf(base), poses));
    if (csv !== undefined && !writeText(csv, writeCsv(stressRows(skeleton, suite)))) return 1;
    console.log(
      stressLines(
        skeleton,
        suite,
        methods.map(({ short }) => short),
      ).join('\n'),
    );
    return 0;
  },
};

/** Says a suite as a table for people, in per cent of the height, and what is worst in it. */
function stressLines(skeleton: Skeleton, suite: StressSuite, shorts: readonly string[]): string[] {
  const { rows, base, size } = suite;
  if (rows.length === 0) return ['No joint deforms the mesh.'];
  const others = shorts.map((_, i) => i).filter((i) => i !== base);
  const part = (length: number): string => `${rounded((100 * length) / size.height, 3)} %`;
  const head = [
    'pose',
    ...others.flatMap((i) => [`${shorts[i]} largest`, `${shorts[i]} mean`]),
    ...shorts.map((short) => `${short} volume`),
  ];
  const body = rows.map(({ pose, numbers }) => [
    stressLabel(skeleton, pose),
    ...others.flatMap((i) => [part(numbers[i]!.largest), part(numbers[i]!.mean)]),
    ...numbers.map(({ volume }) => (volume === null ? '–' : `${(100 * volume).toFixed(1)} %`)),
  ]);
  const worst = rows.reduce((most, row) => (row.largest > most.largest ? row : most));
  const count = rows.length === 1 ? '1 pose' : `${rows.length} poses`;
  return [
    ...aligned([head, ...body]),
    `${count}; differences from ${shorts[base]} in per cent of the height; the largest is` +
      ` ${rounded(worst.largest, 4)} (${part(worst.largest)}), at ${stressLabel(skeleton, worst.pose)}`,
  ];
}

function angleOf(option: string, word: string | undefined, otherwise: number): number {
  if (word === undefined) return otherwise;
  const degrees = word.trim() === '' ? NaN : Number(word);
  if (degrees > 0 && degrees <= 180) return degrees * degree;
  throw new UsageError(`expected ${option} in degrees, above 0 and at most 180, found "${word}"`);
}
