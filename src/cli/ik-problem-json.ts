import { buildSkeleton } from '../core/build-skeleton.ts';
import type { DofParts } from '../core/character-parts.ts';
import { DiagnosticLog, type Parsed } from '../core/diagnostics.ts';
import { defaultLimits } from '../core/limits.ts';
import { jointRange } from '../core/pose.ts';
import { DofKind, noParent, type Skeleton } from '../core/skeleton.ts';
import type { JsonValue } from '../formats/json/decoder.ts';
import { parseJson } from '../formats/json/parse-json.ts';
import type { IkGoal, IkProblem } from '../posing/ik/problem.ts';

/** A problem as its file states it, whose angles are in the file's order. */
export interface IkProblemFile {
  /** The problem's name, for messages; null if it has none. */
  readonly name: string | null;
  readonly problem: IkProblem;
  /** (dofs of the file) the index in q of each. */
  readonly values: readonly number[];
}

export interface IkProblemsFile {
  readonly problems: readonly IkProblemFile[];
  /** Whether the file is a list, so that the answer is one too. */
  readonly isList: boolean;
}

type AxisName = 'x' | 'y' | 'z';

interface FileJoint {
  readonly offset: readonly [number, number, number];
  readonly parent: number;
}

interface FileDof {
  readonly joint: number;
  readonly axis: AxisName;
  readonly limits: readonly [number, number];
}

/** The axes of a joint's hinges, from the outermost. */
const axesOfOrder: Readonly<Record<string, readonly AxisName[]>> = {
  RxRyRz: ['x', 'y', 'z'],
  RzRyRx: ['z', 'y', 'x'],
};

const mostProblems = 10_000;

/**
 * Reads one problem of inverse kinematics, a list of them, or `{"problems": […]}`. A problem has an
 * `order` of its rotations, `joints` (offset, parent), `dofs` (joint, axis, min, max) and
 * `effectors` (joint, local, target); other fields are ignored.
 */
export function readIkProblems(file: string, text: string): Parsed<IkProblemsFile> {
  const log = new DiagnosticLog(file);
  const json = parseJson(text, { log, area: 'ik', effect: 'nothing is solved' });
  if (!json) return log.finish<IkProblemsFile>(undefined);
  const isObject = typeof json.value === 'object' && json.value !== null;
  const outer = isObject && 'problems' in json.value ? json.member('problems') : json;
  const isList = outer !== json || Array.isArray(json.value);
  const items = isList ? outer.list(mostProblems, 'a list of problems') : [json];
  const problems = (items ?? []).map((item) => readProblem(item, log));
  const isWhole = items !== undefined && problems.every((problem) => problem !== undefined);
  return log.finish(isWhole ? { problems, isList } : undefined);
}

function readProblem(json: JsonValue, log: DiagnosticLog): IkProblemFile | undefined {
  const fields = json.record('a problem with "joints", "dofs" and "effectors"');
  if (!fields) return undefined;
  const axes = readOrder(json.member('order'));
  const joints = readAll(json.member('joints'), 'joints', readJoint);
  const dofs = joints && readAll(json.member('dofs'), 'dofs', (dof) => readDof(dof, joints.length));
  const goals =
    joints &&
    readAll(json.member('effectors'), 'effectors', (goal) => readGoal(goal, joints.length));
  if (!axes || !joints || !dofs || !goals || hasDuplicates(json, dofs)) return undefined;
  const skeleton = skeletonOf(joints, dofs, axes, log);
  if (!skeleton) return undefined;
  const { value: name } = json.member('name');
  return {
    name: typeof name === 'string' ? name : null,
    problem: {
      skeleton,
      goals: goals.map((goal) => ({ ...goal, joint: skeleton.jointOfSource[goal.joint]! })),
      joints: Array.from(skeleton.names.keys()),
      reference: skeleton.qRest,
      natures: [],
    },
    values: dofs.map((dof) => valueOf(skeleton, dofs, axes, dof)),
  };
}

function readOrder(json: JsonValue): readonly AxisName[] | undefined {
  const axes = typeof json.value === 'string' ? axesOfOrder[json.value] : undefined;
  if (!axes) json.fail('json', '"order" to be "RxRyRz" or "RzRyRx"');
  return axes;
}

/** Reads every item of a list, so that all errors are reported; nothing if any is wrong. */
function readAll<Item>(
  json: JsonValue,
  name: string,
  read: (item: JsonValue) => Item | undefined,
): Item[] | undefined {
  const items = json.list(defaultLimits.jointCount * 3, `a list of ${name}`)?.map(read);
  return items?.every((item) => item !== undefined) ? items : undefined;
}

function readJoint(json: JsonValue): FileJoint | undefined {
  if (!json.record('a joint with "offset" and "parent"')) return undefined;
  const offset = readTriple(json.member('offset'));
  const parent = readWhole(json.member('parent'), noParent, defaultLimits.jointCount);
  return offset && parent !== undefined ? { offset, parent } : undefined;
}

function readDof(json: JsonValue, jointCount: number): FileDof | undefined {
  if (!json.record('a degree of freedom with "joint" and "axis"')) return undefined;
  const joint = readWhole(json.member('joint'), 0, jointCount - 1);
  const axisJson = json.member('axis');
  const axis = (['x', 'y', 'z'] as const).find((each) => each === axisJson.value);
  if (!axis) axisJson.fail('json', '"axis" to be "x", "y" or "z"');
  const min = readLimit(json.member('min'), -Infinity);
  const max = readLimit(json.member('max'), Infinity);
  if (joint === undefined || !axis || min === undefined || max === undefined) return undefined;
  if (min <= max) return { joint, axis, limits: [min, max] };
  json.member('max').fail('limits', `"max" of at least "min", ${min}`);
  return undefined;
}

function readGoal(json: JsonValue, jointCount: number): IkGoal | undefined {
  if (!json.record('an effector with "joint", "local" and "target"')) return undefined;
  const joint = readWhole(json.member('joint'), 0, jointCount - 1);
  const point = readTriple(json.member('local'));
  const target = readTriple(json.member('target'));
  return joint !== undefined && point && target ? { joint, point, target, weight: 1 } : undefined;
}

function readTriple(json: JsonValue): [number, number, number] | undefined {
  const numbers = json.numbers([3], 'three numbers');
  const far = numbers?.findIndex((value) => Math.abs(value) > defaultLimits.coordinate) ?? -1;
  if (far >= 0) json.member(far).fail('range', `at most ${defaultLimits.coordinate}`);
  return numbers && far < 0 ? [numbers[0]!, numbers[1]!, numbers[2]!] : undefined;
}

function readWhole(json: JsonValue, least: number, most: number): number | undefined {
  const { value } = json;
  if (Number.isInteger(value) && Number(value) >= least && Number(value) <= most)
    return Number(value);
  json.fail('index', `a whole number from ${least} to ${most}`);
  return undefined;
}

/** An absent limit and null are none. */
function readLimit(json: JsonValue, none: number): number | undefined {
  if (json.value === undefined || json.value === null) return none;
  if (typeof json.value === 'number' && Number.isFinite(json.value)) return json.value;
  json.fail('json', 'a number of radians, or null');
  return undefined;
}

function hasDuplicates(json: JsonValue, dofs: readonly FileDof[]): boolean {
  const again = dofs.findIndex((dof, index) => {
    return dofs.findIndex(({ joint, axis }) => joint === dof.joint && axis === dof.axis) < index;
  });
  if (again < 0) return false;
  json.member('dofs').member(again).fail('duplicate', 'each axis of a joint once');
  return true;
}

function skeletonOf(
  joints: readonly FileJoint[],
  dofs: readonly FileDof[],
  axes: readonly AxisName[],
  log: DiagnosticLog,
): Skeleton | undefined {
  const parts = joints.map(({ offset, parent }, joint) => ({
    name: `#${joint}`,
    restOffset: offset,
    parent,
    dofs: inOrder(dofs, axes, joint).map(({ axis, limits }): DofParts => ({
      kind: DofKind.hinge,
      axis: unitAxes[axis],
      limits,
    })),
  }));
  return buildSkeleton({ file: '', joints: parts }, log);
}

const unitAxes = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] } as const;

/** The degrees of freedom of a joint, the outermost first. */
function inOrder(dofs: readonly FileDof[], axes: readonly AxisName[], joint: number): FileDof[] {
  return dofs
    .filter((dof) => dof.joint === joint)
    .sort((a, b) => axes.indexOf(a.axis) - axes.indexOf(b.axis));
}

function valueOf(
  skeleton: Skeleton,
  dofs: readonly FileDof[],
  axes: readonly AxisName[],
  dof: FileDof,
): number {
  const [first] = jointRange(skeleton, skeleton.jointOfSource[dof.joint]!);
  return first + inOrder(dofs, axes, dof.joint).indexOf(dof);
}
