import { DiagnosticLog, type Parsed } from '../core/diagnostics.ts';
import { defaultLimits } from '../core/limits.ts';
import { axisDofs, type Pose, restPose } from '../core/pose.ts';
import { setAxisValues } from './axis-values.ts';
import { boundText } from './text/write-number.ts';
import { DofKind, firstRoot, type Skeleton } from '../core/skeleton.ts';

/**
 * A pose as people write and exchange it: angles x, y, z in radians by joint name or `#` and the
 * joint's index in the file; `root` displaces the first root from its place in the file.
 */
export interface PoseJson {
  joints?: Record<string, [number, number, number]>;
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
    if (typeof joint === 'string') fail('unknown-joint', joint, name);
    else if (isTripleOf(`"${name}"`, value)) {
      setAxisValues(skeleton, pose, joint, DofKind.hinge, value, log);
    }
  }

  function setRoot(value: unknown): void {
    if (!isTripleOf('"root"', value)) return;
    setAxisValues(skeleton, pose, firstRoot(skeleton), DofKind.slide, value, log);
  }

  function isTripleOf(what: string, value: unknown): value is [number, number, number] {
    const largest = defaultLimits.coordinate;
    if (!isTriple(value)) fail('json', `three numbers for ${what}`, display(value));
    else if (value.every((item) => Math.abs(item) <= largest)) return true;
    else fail('range', `numbers within ±${boundText(largest)} for ${what}`, display(value));
    return false;
  }

  function fail(kind: PoseFault, expected: string, found: string): void {
    log.error({ code: `pose/${kind}`, expected, found, effect });
  }
}

/** The pose as JSON: only joints that differ from the file's pose, by name. */
export function poseToJson(skeleton: Skeleton, pose: Pose): PoseJson {
  const joints: [string, [number, number, number]][] = [];
  for (let joint = 0; joint < skeleton.jointCount; joint++) {
    const angles = axisValues(skeleton, pose, joint, DofKind.hinge);
    if (angles) joints.push([skeleton.names[joint]!, angles]);
  }
  const root = firstRoot(skeleton);
  const displacement = root >= 0 && axisValues(skeleton, pose, root, DofKind.slide);
  // From entries, since a joint may have any name, "__proto__" too.
  return { joints: Object.fromEntries(joints), ...(displacement ? { root: displacement } : {}) };
}

/** x, y, z of a joint's hinges or slides, or nothing where they are as in the file. */
function axisValues(
  skeleton: Skeleton,
  pose: Pose,
  joint: number,
  kind: DofKind,
): [number, number, number] | undefined {
  const values: [number, number, number] = [0, 0, 0];
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

function isTriple(value: unknown): value is [number, number, number] {
  return Array.isArray(value) && value.length === 3 && value.every((item) => Number.isFinite(item));
}
