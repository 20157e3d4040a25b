import { convert } from './convert.ts';
import { info } from './info.ts';
import { pose } from './pose.ts';
import { sample } from './sample.ts';

/** A seam: a new command is one file and one line here. */
export interface Command {
  readonly name: string;
  readonly usage: string;
  /** The exit code. */
  run(words: readonly string[]): Promise<number>;
}

export const commands: readonly Command[] = [info, pose, convert, sample];
