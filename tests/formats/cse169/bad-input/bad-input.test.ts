import { shown } from '../../../support/diagnose.ts';
import { testBadInputs } from '../../bad-input.ts';
import { skelTrees } from './skel-trees.ts';
import { skelValues } from './skel-values.ts';
import { skinSections } from './skin-sections.ts';
import { skinWeights } from './skin-weights.ts';
import { textCases } from './text-cases.ts';

testBadInputs('bad files of CSE169', {
  letter: 'B',
  kinds: 66,
  say: shown,
  cases: [...textCases, ...skelTrees, ...skelValues, ...skinSections, ...skinWeights],
});
