import { DiagnosticLog, type Parsed } from '../core/diagnostics.ts';
import { defaultLimits } from '../core/limits.ts';
import type { AxisDof, Pose } from '../core/pose.ts';
import { setAxisValues } from './axis-values.ts';
import { ballValue, type BallJson, quaternionOf } from './ball-values.ts';
import { checkVersion, display, JsonValue } from './json/decoder.ts';
import { boundText } from './text/bound-text.ts';
import { DofKind, type Skeleton } from '../core/skeleton.ts';
import { firstRoot } from '../core/subtree.ts';

/**
 * A pose in the form that people write and exchange: angles x, y, z in radians by joint name, or by
 * `#` and the joint's index in the file. `root` displaces the first root from its place in the
 * file. A ball joint takes a quaternion x, y, z, w instead, or angles of R = Rx · Ry · Rz. All
 * values are in Sinew's right-handed space.
 */
export interface PoseJson {
  /** The version of this form; 1, the only one so far, if absent. */
  version?: number;
  joints?: Record<string, BallJson>;
  root?: [number, number, number];
}

/**
 * Returns the pose that a plain value describes. Joints that it does not name keep the file's pose.
 * Values beyond a joint's limits are clamped, and values for an axis that the joint does not have
 * are ignored, each with a warning.
 */
export function poseFromJson(file: string, value: unknown, skeleton: Skeleton): Parsed<Pose> {
  const log = new DiagnosticLog(file);
  return decodePose(new JsonValue({ value }, { log, area: 'pose', effect: unused }), skeleton);
}

/** The consequence of an error in a pose. */
export const unused = 'the pose is not used';

/**
 * Like `poseFromJson`, from a value that knows its place in the text.
 *
 * @param onto (qCount) the pose that joints keep which it does not name; the file's, if absent
 */
export function decodePose(
  json: JsonValue,
  skeleton: Skeleton,
  onto = skeleton.qRest,
): Parsed<Pose> {
  const { log } = json.source;
  const pose: Pose = { q: onto.slice() };
  const members = json.record('an object with "joints" and "root"');
  if (!members || !checkVersion(members)) return log.finish<Pose>(undefined);
  for (const [name, member] of members) {
    if (!['joints', 'root', 'version'].includes(name)) {
      member.failName('unknown', '"joints" or "root"', name);
    }
  }
  const joints = members.get('joints');
  const root = members.get('root');
  if (joints?.value !== undefined) {
    for (const entry of joints.record('"joints" to be an object') ?? []) setJoint(...entry);
  }
  if (root?.value !== undefined) setRoot(root);
  return log.finish(pose);

  function setJoint(name: string, angles: JsonValue): void {
    const joint = findJoint(skeleton, name);
    if (typeof joint === 'string') {
      angles.failName('unknown-joint', joint, name);
      return;
    }
    const ball = ballValue(skeleton, joint);
    if (ball >= 0) setBall(name, angles, ball);
    else setAxes(joint, DofKind.hinge, angles, `"${name}"`);
  }

  function setBall(name: string, json: JsonValue, at: number): void {
    const values = boundedNumbers(json, [3, 4], `three or four numbers for "${name}"`, `"${name}"`);
    if (!values) return;
    const unit = quaternionOf(values as BallJson);
    if (unit.every(Number.isFinite)) pose.q.set(unit, at);
    else json.fail('range', `a quaternion with a length for "${name}"`);
  }

  function setRoot(json: JsonValue): void {
    setAxes(firstRoot(skeleton), DofKind.slide, json, '"root"');
  }

  function setAxes(joint: number, kind: AxisDof['kind'], json: JsonValue, what: string): void {
    const values = boundedNumbers(json, [3], `three numbers for ${what}`, what);
    if (values) setAxisValues(skeleton, pose, joint, kind, values, json);
  }
}

/**
 * Returns a list of numbers whose length is one of the counts, none larger than can be computed
 * with.
 */
function boundedNumbers(
  json: JsonValue,
  counts: readonly number[],
  expected: string,
  what: string,
): readonly number[] | undefined {
  const largest = defaultLimits.coordinate;
  const values = json.numbers(counts, expected);
  const wrong = values?.findIndex((value) => Math.abs(value) > largest) ?? -1;
  if (wrong < 0) return values;
  const bound = `numbers within ±${boundText(largest)} for ${what}`;
  json.member(wrong).fail('range', bound, display(values));
  return undefined;
}

/** The joint of a name or of `#index`, or the text that says what was expected. */
export function findJoint(skeleton: Skeleton, name: string): number | string {
  if (/^#\d+$/.test(name)) {
    const source = Number(name.slice(1));
    return skeleton.jointOfSource[source] ?? `a joint from #0 to #${skeleton.jointCount - 1}`;
  }
  const joint = skeleton.names.indexOf(name);
  if (joint === -1) return `the name of a joint, or # and its index${suggestion(skeleton, name)}`;
  if (skeleton.names.includes(name, joint + 1)) return 'a name that only one joint has';
  return joint;
}

function suggestion(skeleton: Skeleton, name: string): string {
  const similar = skeleton.names.find((known) => known.toLowerCase() === name.toLowerCase());
  return similar === undefined ? '' : ` ("${similar}"?)`;
}
