import type { Command } from './command.ts';
import { compare } from './compare.ts';
import { convert } from './convert.ts';
import { ik } from './ik.ts';
import { info } from './info.ts';
import { pose } from './pose.ts';
import { sample } from './sample.ts';
import { stress } from './stress.ts';
import { sweep } from './sweep.ts';

/** Every command of the command line. */
export const commands: readonly Command[] = [
  info,
  pose,
  compare,
  stress,
  sweep,
  convert,
  sample,
  ik,
];
