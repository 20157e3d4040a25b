import { DiagnosticLog, type Parsed } from '../core/diagnostics.ts';
import { defaultLimits } from '../core/limits.ts';
import { axisDofs, type Pose, restPose } from '../core/pose.ts';
import { setAxisValues } from './axis-values.ts';
import {
  ballValue,
  type BallJson,
  type Quaternion,
  quaternionOf,
  type Triple,
} from './ball-values.ts';
import { boundText } from './text/write-number.ts';
import { DofKind, firstRoot, type Skeleton } from '../core/skeleton.ts';

/**
 * A pose as people write and exchange it: angles x, y, z in radians by joint name or `#` and the
 * joint's index in the file; `root` displaces the first root from its place in the file. A ball joint
 * takes a quaternion x, y, z, w instead, or angles of R = Rx · Ry · Rz. In Sinew's right-handed space.
 */
export interface PoseJson {
  joints?: Record<string, BallJson>;
  root?: [number, number, number];
}

const effect = 'the pose is not used';

type PoseFault = 'json' | 'range' | 'unknown' | 'unknown-joint';

/**
 * The pose that the text describes; joints it does not name keep the file's pose. Values past a
 * joint's limits are clamped, and those that it has no freedom for left out, each with a warning.
 */
export function readPoseJson(file: string, text: string, skeleton: Skeleton): Parsed<Pose> {
  const log = new DiagnosticLog(file);
  let json: unknown;
  try {
    json = JSON.parse(text.replace(/^\uFEFF/, ''));
  } catch (error) {
    const found = error instanceof Error ? error.message : 'something else';
    log.error({ code: 'pose/json', expected: 'JSON', found, effect });
    return log.finish<Pose>(undefined);
  }
  return poseFromJson(file, json, skeleton);
}

/** As `readPoseJson`, from a value. */
export function poseFromJson(file: string, json: unknown, skeleton: Skeleton): Parsed<Pose> {
  const log = new DiagnosticLog(file);
  const pose = restPose(skeleton);
  if (!isRecord(json)) {
    fail('json', 'an object with "joints" and "root"', display(json));
    return log.finish<Pose>(undefined);
  }
  for (const key of Object.keys(json)) {
    if (key !== 'joints' && key !== 'root') fail('unknown', '"joints" or "root"', key);
  }
  const { joints = {}, root } = json;
  if (!isRecord(joints)) fail('json', '"joints" to be an object', display(joints));
  else for (const [name, angles] of Object.entries(joints)) setAngles(name, angles);
  if (root !== undefined) setRoot(root);
  return log.finish(pose);

  function setAngles(name: string, value: unknown): void {
    const joint = findJoint(skeleton, name);
    const ball = typeof joint === 'string' ? -1 : ballValue(skeleton, joint);
    if (typeof joint === 'string') fail('unknown-joint', joint, name);
    else if (ball >= 0) setBall(name, value, ball);
    else if (isTripleOf(`"${name}"`, value)) {
      setAxisValues(skeleton, pose, joint, DofKind.hinge, value, log);
    }
  }

  function setBall(name: string, value: unknown, at: number): void {
    if (!isNumbers(value, 4)) {
      if (isTripleOf(`"${name}"`, value, 'three or four')) pose.q.set(quaternionOf(value), at);
      return;
    }
    if (!isWithin(`"${name}"`, value)) return;
    const unit = quaternionOf(value);
    if (unit.every(Number.isFinite)) pose.q.set(unit, at);
    else fail('range', `a quaternion with a length for "${name}"`, display(value));
  }

  function setRoot(value: unknown): void {
    if (!isTripleOf('"root"', value)) return;
    setAxisValues(skeleton, pose, firstRoot(skeleton), DofKind.slide, value, log);
  }

  function isTripleOf(what: string, value: unknown, count = 'three'): value is Triple {
    if (isNumbers(value, 3)) return isWithin(what, value);
    fail('json', `${count} numbers for ${what}`, display(value));
    return false;
  }

  function isWithin(what: string, values: readonly number[]): boolean {
    const largest = defaultLimits.coordinate;
    if (values.every((item) => Math.abs(item) <= largest)) return true;
    fail('range', `numbers within ±${boundText(largest)} for ${what}`, display(values));
    return false;
  }

  function fail(kind: PoseFault, expected: string, found: string): void {
    log.error({ code: `pose/${kind}`, expected, found, effect });
  }
}

/** The pose as JSON: only joints that differ from the file's pose, by name. */
export function poseToJson(skeleton: Skeleton, pose: Pose): PoseJson {
  const joints: [string, BallJson][] = [];
  for (let joint = 0; joint < skeleton.jointCount; joint++) {
    const values =
      ballValues(skeleton, pose, joint) ?? axisValues(skeleton, pose, joint, DofKind.hinge);
    if (values) joints.push([skeleton.names[joint]!, values]);
  }
  const root = firstRoot(skeleton);
  const displacement = root >= 0 && axisValues(skeleton, pose, root, DofKind.slide);
  // From entries, since a joint may have any name, "__proto__" too.
  return { joints: Object.fromEntries(joints), ...(displacement ? { root: displacement } : {}) };
}

/** The quaternion of a joint's ball, or nothing where it has none or it is as in the file. */
function ballValues(skeleton: Skeleton, { q }: Pose, joint: number): Quaternion | undefined {
  const at = ballValue(skeleton, joint);
  const values = at < 0 ? [] : [...q.subarray(at, at + 4)];
  return values.some((value, i) => value !== skeleton.qRest[at + i])
    ? (values as Quaternion)
    : undefined;
}

/** x, y, z of a joint's hinges or slides, or nothing where they are as in the file. */
function axisValues(
  skeleton: Skeleton,
  pose: Pose,
  joint: number,
  kind: DofKind,
): Triple | undefined {
  const values: Triple = [0, 0, 0];
  let changed = false;
  for (const dof of axisDofs(skeleton, joint)) {
    if (dof.kind !== kind) continue;
    values[dof.axis] = pose.q[dof.index]!;
    changed ||= pose.q[dof.index] !== skeleton.qRest[dof.index];
  }
  return changed ? values : undefined;
}

/** The joint of a name or of `#index`; or what was expected in its place. */
function findJoint(skeleton: Skeleton, name: string): number | string {
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

/** A value as a message shows it; callers may pass what JSON has not. */
function display(value: unknown): string {
  try {
    const text = JSON.stringify(value) as string | undefined;
    return text ?? typeof value;
  } catch {
    return typeof value;
  }
}

function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

function isNumbers(value: unknown, count: 3): value is Triple;
function isNumbers(value: unknown, count: 4): value is Quaternion;
function isNumbers(value: unknown, count: number): boolean {
  return (
    Array.isArray(value) && value.length === count && value.every((item) => Number.isFinite(item))
  );
}
