import { said } from '../../../support/diagnose.ts';
import { testBadInputs } from '../../bad-input.ts';
import { attachCases } from './attach-cases.ts';
import { objFaces } from './obj-faces.ts';
import { objLines } from './obj-lines.ts';
import { setCases } from './set-cases.ts';
import { skelNumbers } from './skel-numbers.ts';
import { skelTrees } from './skel-trees.ts';
import { textCases } from './text-cases.ts';

testBadInputs('bad files of 6.837', {
  letter: 'A',
  kinds: 68,
  say: said,
  cases: [
    ...[...skelNumbers, ...skelTrees, ...textCases],
    ...[...objLines, ...objFaces, ...attachCases, ...setCases],
  ],
});
