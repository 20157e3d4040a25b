/**
 * `npm run ik-figures` measures the methods of inverse kinematics and writes the table of docs/ik.md.
 * It takes some minutes, so no test repeats it; `npm run test:long -- ik` checks what must hold.
 */
import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { format } from 'oxfmt';
import { ikMethods } from '../src/posing/ik/methods.ts';
import { handsAndFeet, leg, sixBalls } from '../tests/posing/ik/ik-rigs.ts';
import { measureMethod } from '../tests/posing/ik/measure-method.ts';
import { root } from './commands.mjs';

const targetCount = 200;
const file = path.join(root, 'docs/ik.md');
const block = /(?<=<!-- figures -->)[^]*(?=<!-- \/figures -->)/;

const rigs = {
  'six balls within ±0.7': sixBalls(),
  'leg with a one-sided knee': leg(),
  'both hands, feet pinned': await handsAndFeet(),
};

const rows = [
  `| ${targetCount} targets each | method | solved | worst residual | iterations, median | ms, median |`,
  '| --- | --- | --- | --- | --- | --- |',
];
for (const [name, rig] of Object.entries(rigs)) {
  for (const { id, label } of ikMethods) {
    const figures = await measureMethod(id, rig, targetCount);
    const solved = `${((100 * figures.solved) / targetCount).toFixed(1)} %`;
    const worst = figures.worst.toExponential(0).replace('e', ' · 10^');
    const { medianIterations: iterations, medianMilliseconds: time } = figures;
    const cells = [name, label, solved, worst, `${iterations}`, time.toPrecision(2)];
    rows.push(`| ${cells.join(' | ')} |`);
    console.log(rows.at(-1));
  }
}
const text = readFileSync(file, 'utf8').replace(block, `\n\n${rows.join('\n')}\n\n`);
writeFileSync(file, (await format(file, text)).code);
