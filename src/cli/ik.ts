import { parseArgs } from 'node:util';
import { ikMethods } from '../posing/ik/methods.ts';
import type { IkSolver } from '../posing/ik/problem.ts';
import type { Command } from './command.ts';
import { type PoseRequest, poseToTargets } from './ik-pose.ts';
import { solveProblems } from './ik-problems.ts';
import { parseWords } from './parse-words.ts';
import { UsageError } from './usage-error.ts';

const methodIds = ikMethods.map(({ id }) => id).join('|');

/** Solves inverse kinematics: problems that a file states, or a character's pose for some targets. */
export const ik: Command = {
  name: 'ik',
  usage:
    `ik PROBLEM.json [--method ${methodIds}] [--json]\n  ` +
    `sinew ik FILES --target 'JOINT[@tip]=x,y,z' [--pin JOINT[@tip]] [--pose START.json|START.vpd] [--method ${methodIds}] [--json] --out POSE.json`,
  summary:
    "Solves inverse kinematics. A PROBLEM.json has joints, degrees of freedom with limits, and effectors with targets; the angles that bring the effectors to their targets are printed. With files of a character, it writes the pose in which joints are at their targets, in the character's space and the file's units, while pinned joints stay where they are in the starting pose; --target and --pin may be repeated, and @tip means the end of a joint's bone, as `info --bones` gives it. Each residual and status is printed: reached, limits, out-of-reach or stalled.",
  async run(words) {
    const { files, pose, solver, json } = await parseOptions(words);
    return pose ? poseToTargets(files, pose, solver, json) : solveProblems(files, solver, json);
  },
};

interface Options {
  readonly files: readonly string[];
  /** Null where the file states the problem. */
  readonly pose: PoseRequest | null;
  readonly solver: IkSolver;
  readonly json: boolean;
}

async function parseOptions(words: readonly string[]): Promise<Options> {
  const { values, positionals: files } = parseWords(() =>
    parseArgs({
      args: [...words],
      options: {
        method: { type: 'string', default: 'dls' },
        json: { type: 'boolean', default: false },
        pose: { type: 'string' },
        target: { type: 'string', multiple: true },
        pin: { type: 'string', multiple: true },
        out: { type: 'string' },
      },
      allowPositionals: true,
    }),
  );
  const { method: id, json, pose: start, target, pin: pins = [], out } = values;
  const method = ikMethods.find((each) => each.id === id);
  if (!method) throw new UsageError(`expected --method ${methodIds}, found "${id}"`);
  const solver = await method.load();
  if (files.length === 0) throw new UsageError('expected files, found none');
  if (target === undefined && pins.length === 0 && start === undefined && out === undefined) {
    if (files.length > 1) throw new UsageError('expected one file of problems, or --target');
    return { files, pose: null, solver, json };
  }
  if (target === undefined) throw new UsageError("expected --target 'JOINT=x,y,z'");
  if (out === undefined) throw new UsageError('expected --out POSE.json');
  return { files, pose: { start, targets: target.map(parseTarget), pins, out }, solver, json };
}

/** Reads "Left hand=0.3,1,0.2"; a joint's name may have an equals sign. */
function parseTarget(word: string): { name: string; place: [number, number, number] } {
  const at = word.lastIndexOf('=');
  const parts = word.slice(at + 1).split(',');
  const numbers = parts.map((part) => (part.trim() === '' ? NaN : Number(part)));
  if (at < 1 || numbers.length !== 3 || !numbers.every(Number.isFinite)) {
    throw new UsageError(`expected --target 'JOINT=x,y,z', found "${word}"`);
  }
  return { name: word.slice(0, at), place: [numbers[0]!, numbers[1]!, numbers[2]!] };
}
