import { mat3, quat, vec3 } from 'gl-matrix';
import { bonesOf } from '../core/bones.ts';
import type { Character } from '../core/character.ts';
import { noParent } from '../core/skeleton.ts';
import { bodyOf } from './natural/body.ts';
import { naturesOf } from './natural/natures.ts';
import { rollJoint } from './roll-joint.ts';
import { sharingJoints } from './sharing-joints.ts';
import { turnAbout, turnJoint, type TurnStart, turnStart } from './turn-joint.ts';

/** A pose in which skinning methods differ, with what makes it as a label. */
export interface TellingPose {
  readonly label: string;
  /** (qCount) */
  readonly q: Float64Array;
}

const degree = Math.PI / 180;
const [twist, bend] = [150 * degree, 120 * degree];
/** A joint that its limits let turn less hardly shows what methods do. */
const leastTurn = 60 * degree;

/** A way to turn a joint that shows what methods do. */
interface TurnKind {
  readonly name: 'Twist' | 'Bend';
  readonly ofElbow: string;
  readonly turned: (character: Character, q: Float64Array, joint: number) => Float64Array;
}

const kinds: readonly TurnKind[] = [
  { name: 'Twist', ofElbow: 'Twist the forearm', turned: twisted },
  { name: 'Bend', ofElbow: 'Bend the elbow', turned: bent },
];

/** The joint that shows what methods do, and in which ways. */
interface TellingJoint {
  readonly joint: number;
  readonly ways: readonly TurnKind[];
}

const known = new WeakMap<Character, TellingJoint | null>();

/**
 * Returns the pose with one joint twisted along its limb, and with it bent, as far as it can do each:
 * an elbow, or else a joint that shares many points with its parent. What its limits hardly allow is
 * left out.
 *
 * @param q (qCount) the pose before
 */
export function tellingPoses(character: Character, q: Float64Array): readonly TellingPose[] {
  const found = tellingJointOf(character);
  if (!found) return [];
  const { joint, ways } = found;
  const isElbow = bodyOf(character).roles[joint] === 'elbow';
  const poses = ways.map(({ name, ofElbow, turned }): TellingPose => {
    const label = isElbow ? ofElbow : `${name} ${character.skeleton.names[joint]!}`;
    return { label, q: turned(character, q, joint) };
  });
  return poses.filter((pose) => pose.q.some((value, i) => value !== q[i]));
}

/**
 * An elbow, or else the joint that shares the most points with its parent, of those that turn far
 * enough if there are any; null if no joint shares points.
 */
export function tellingJoint(character: Character): number | null {
  return tellingJointOf(character)?.joint ?? null;
}

function tellingJointOf(character: Character): TellingJoint | null {
  let found = known.get(character);
  if (found === undefined) known.set(character, (found = findTellingJoint(character)));
  return found;
}

function findTellingJoint(character: Character): TellingJoint | null {
  const elbow = bodyOf(character).roles.indexOf('elbow');
  const joints = elbow < 0 ? sharingJoints(character) : [elbow];
  for (const joint of joints) {
    const ways = kinds.filter((kind) => turnsFar(character, joint, kind));
    if (ways.length > 0) return { joint, ways };
  }
  return joints.length > 0 ? { joint: joints[0]!, ways: kinds } : null;
}

/** Whether a joint's limits leave room for a turn from the pose at rest. */
function turnsFar(character: Character, joint: number, { turned }: TurnKind): boolean {
  const { skeleton } = character;
  const { qRest } = skeleton;
  const [before, after] = [qRest, turned(character, qRest, joint)].map((q) => {
    const { characterFromJoint } = turnStart(skeleton, joint, q).frames;
    return Array.from(mat3.fromMat4(new Float64Array(9), characterFromJoint));
  });
  // The trace of a rotation is 1 + 2 cos of its angle; that of AᵀB is the sum of products.
  const trace = before!.reduce((sum, value, i) => sum + value * after![i]!, 0);
  return (trace - 1) / 2 <= Math.cos(leastTurn);
}

function twisted(character: Character, q: Float64Array, joint: number): Float64Array {
  const end = limbEnd(character, joint);
  const rolled = rollJoint(character.skeleton, q, joint, end, twist);
  if (rolled.some((value, i) => value !== q[i])) return rolled;
  const hand = wristBelow(character, joint);
  // An elbow that is a mere hinge leaves this to the wrist.
  return hand === null
    ? rolled
    : rollJoint(character.skeleton, q, hand, limbEnd(character, hand), twist);
}

function bent(character: Character, q: Float64Array, joint: number): Float64Array {
  const start = turnStart(character.skeleton, joint, q);
  return turnJoint(start, turnAbout(bendAxis(character, joint, start), bend), q);
}

/** The axis of bending by nature, or one at a right angle to the limb; character space. */
export function bendAxis(character: Character, joint: number, start: TurnStart): vec3 {
  const characterFromJoint = start.frames.characterFromJoint;
  const rotation = mat3.fromMat4(new Float64Array(9), characterFromJoint);
  const nature = naturesOf(character).find((each) => each.joint === joint);
  if (nature) {
    const [x, y, z, w] = nature.jointFromNature;
    const axis = vec3.transformQuat(new Float64Array(3), [1, 0, 0], quat.fromValues(x, y, z, w));
    return vec3.normalize(axis, vec3.transformMat3(axis, axis, rotation));
  }
  const along = vec3.transformMat3(new Float64Array(3), limbEnd(character, joint), rotation);
  vec3.normalize(along, along);
  const across = (axis: vec3): number => 1 - Math.abs(vec3.dot(axis, along));
  // A hinge of its own bends a joint best, where one lies across the limb.
  const [hinge] = [...start.free].sort((a, b) => across(b.axis) - across(a.axis));
  if (hinge && across(hinge.axis) > 0.5) return hinge.axis;
  const other: vec3 = Math.abs(along[2]) < 0.9 ? [0, 0, 1] : [0, 1, 0];
  const axis = vec3.cross(new Float64Array(3), along, other);
  return vec3.normalize(axis, axis);
}

/** The far end of a joint's longest bone, in the joint's frame. */
export function limbEnd(character: Character, joint: number): readonly [number, number, number] {
  const own = bonesOf(character).filter((bone) => bone.joint === joint);
  const [longest] = own.sort((a, b) => Math.hypot(...b.vector) - Math.hypot(...a.vector));
  return longest?.vector ?? [0, 0, 0];
}

function wristBelow(character: Character, elbow: number): number | null {
  const { parents, jointCount } = character.skeleton;
  const { roles } = bodyOf(character);
  const isBelow = (joint: number): boolean => {
    for (let at = joint; at !== noParent; at = parents[at]!) if (at === elbow) return true;
    return false;
  };
  for (let joint = elbow + 1; joint < jointCount; joint++) {
    if (roles[joint] === 'wrist' && isBelow(joint)) return joint;
  }
  return null;
}
