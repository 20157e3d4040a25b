import { writeFileSync } from 'node:fs';
import { bonesOf } from '../core/bones.ts';
import type { Character } from '../core/character.ts';
import { type Diagnostic, hasErrors, printable } from '../core/diagnostics.ts';
import { jointMatrices } from '../core/forward-kinematics.ts';
import type { Skeleton } from '../core/skeleton.ts';
import { findJoint } from '../formats/pose-json.ts';
import { readCharacters } from '../formats/read-characters.ts';
import { poseToJson } from '../formats/write-pose-json.ts';
import { naturalLength, pathTo } from '../posing/ik/chain.ts';
import { type GoalChain, goalChains } from '../posing/ik/goal-chains.ts';
import type { IkGoal, IkProblem, IkSolution, IkSolver, Vector3 } from '../posing/ik/problem.ts';
import { statusOf } from '../posing/ik/status.ts';
import { naturesOf } from '../posing/natural/natures.ts';
import { printDiagnostics, readFiles, unwritable, userPath } from './files.ts';
import { givenPose } from './read-pose-file.ts';
import { UsageError } from './usage-error.ts';

/** A pose that is asked for. */
export interface PoseRequest {
  /** The path of the starting pose; the files' pose if absent. */
  readonly start: string | undefined;
  readonly targets: readonly { readonly name: string; readonly place: Vector3 }[];
  readonly pins: readonly string[];
  readonly out: string;
}

/** A pinned joint counts ten times as much as one with a target. */
const pinWeight = 10;
const tipMark = '@tip';

/** Writes the pose in which the joints of one character are at their targets, and prints how near. */
export async function poseToTargets(
  paths: readonly string[],
  request: PoseRequest,
  solver: IkSolver,
  asJson: boolean,
): Promise<number> {
  const { files, diagnostics: missing } = readFiles(paths);
  const { characters, diagnostics } = await readCharacters(files);
  if (characters.length > 1) throw new UsageError('expected the files of one character');
  const found: Diagnostic[] = [...missing, ...diagnostics];
  const character = characters[0]?.character;
  const start = character && (await givenPose(request.start, character, found));
  printDiagnostics(found);
  if (!character || !start || hasErrors(found)) return 1;
  const problem = problemOf(character, start.q, request);
  const solution = solver.solve(problem);
  const json = poseToJson(character.skeleton, { ...start, q: solution.q });
  try {
    writeFileSync(userPath(request.out), `${JSON.stringify(json, null, 2)}\n`);
  } catch (error) {
    printDiagnostics([unwritable(request.out, error)]);
    return 1;
  }
  print(request, problem, solution, asJson);
  return 0;
}

/**
 * Without pins the limbs with a target move, as they do when they are dragged on the page: each from
 * where the body branches. With pins the whole body between targets and pins does, and its root.
 */
function problemOf(character: Character, q: Float64Array, request: PoseRequest): IkProblem {
  const { skeleton } = character;
  const goals = [
    ...request.targets.map(({ name, place }): IkGoal => {
      return { ...pointNamed(character, name), target: place, weight: 1 };
    }),
    ...request.pins.map((name): IkGoal => {
      const pinned = pointNamed(character, name);
      return { ...pinned, target: placeOf(skeleton, q, pinned), weight: pinWeight };
    }),
  ];
  const hasPins = request.pins.length > 0;
  const moving = goals.flatMap(({ joint }) => {
    const path = pathTo(skeleton, joint);
    return hasPins ? path : path.slice(-naturalLength(skeleton, joint));
  });
  const joints = [...new Set(moving)].sort((a, b) => a - b);
  return { skeleton, goals, joints, reference: q, natures: naturesOf(character) };
}

/** A joint's origin or, after `@tip`, the end of its bone, in the joint's frame. */
function pointNamed(character: Character, word: string): { joint: number; point: Vector3 } {
  const isTip = word.endsWith(tipMark);
  const name = isTip ? word.slice(0, -tipMark.length) : word;
  const joint = findJoint(character.skeleton, name);
  if (typeof joint === 'string') throw new UsageError(`expected ${joint}, found "${name}"`);
  if (!isTip) return { joint, point: [0, 0, 0] };
  const bone = bonesOf(character).find((each) => each.joint === joint);
  if (!bone) throw new UsageError(`expected a joint with a bone, found "${name}"`);
  return { joint, point: bone.vector };
}

function placeOf(
  skeleton: Skeleton,
  q: Float64Array,
  { joint, point: [x, y, z] }: { joint: number; point: Vector3 },
): Vector3 {
  const m = jointMatrices(skeleton, q).subarray(joint * 16, joint * 16 + 16);
  const row = (r: number): number => m[r]! * x + m[4 + r]! * y + m[8 + r]! * z + m[12 + r]!;
  return [row(0), row(1), row(2)];
}

function print(
  { targets, pins }: PoseRequest,
  problem: IkProblem,
  solution: IkSolution,
  asJson: boolean,
): void {
  const chains = goalChains(problem);
  const goals = [...targets.map(({ name }) => name), ...pins].map((name, index) => ({
    name,
    residual: solution.residuals[index]!,
    status: ownStatus(problem.goals[index]!, chains[index]!, solution, index),
  }));
  const { iterations, status } = solution;
  if (asJson) {
    const parts = { targets: goals.slice(0, targets.length), pins: goals.slice(targets.length) };
    console.log(JSON.stringify({ ...parts, iterations, status }, null, 2));
    return;
  }
  for (const { name, residual, status: own } of goals)
    console.log(`${printable(name, 200)}: ${own}, residual ${residual.toExponential(2)}`);
}

/** The status as if the goal were the only one. */
function ownStatus(goal: IkGoal, chain: GoalChain, solution: IkSolution, index: number) {
  const { residuals, turns, atLimits } = solution;
  return statusOf([goal], [chain], [residuals[index]!], [turns[index]!], atLimits);
}
