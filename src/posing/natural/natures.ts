import { mat3, quat, vec3 } from 'gl-matrix';
import type { Character } from '../../core/character.ts';
import type { JointNature } from '../ik/problem.ts';
import { angleBetween } from './angle-between.ts';
import { type Body, bodyOf } from './body.ts';
import { curlAxis } from './curl.ts';
import type { JointRole } from './roles.ts';

type Range = readonly [number, number];

/** In degrees, from the pose in which all degrees of freedom are zero. */
interface Habit {
  readonly stiffness: number;
  readonly bend: Range;
  readonly side: Range;
  readonly twist: Range;
  /** Whether bending is counted from the straight limb instead. */
  readonly fromStraight?: boolean;
}

const free: Range = [-180, 180];
const about = (degrees: number): Range => [-degrees, degrees];

/**
 * How far joints turn without effort, rounded from textbooks of joint motion, and how unwilling
 * they are beside an elbow, which is 1.
 */
const habits: Readonly<Record<JointRole, Habit>> = {
  root: { stiffness: 10, bend: free, side: free, twist: free },
  pelvis: { stiffness: 6, bend: about(40), side: about(30), twist: about(40) },
  spine: { stiffness: 4, bend: about(25), side: about(20), twist: about(20) },
  neck: { stiffness: 4, bend: about(30), side: about(25), twist: about(40) },
  head: { stiffness: 4, bend: about(30), side: about(25), twist: about(50) },
  clavicle: { stiffness: 4, bend: about(15), side: about(15), twist: about(5) },
  shoulder: { stiffness: 1, bend: free, side: free, twist: about(90) },
  elbow: { stiffness: 1, bend: [-2, 150], side: about(3), twist: about(80), fromStraight: true },
  wrist: { stiffness: 2, bend: about(60), side: about(35), twist: about(10) },
  hip: { stiffness: 1, bend: [-30, 120], side: [-30, 60], twist: about(45) },
  knee: { stiffness: 1, bend: [-2, 150], side: about(3), twist: about(10), fromStraight: true },
  ankle: { stiffness: 2, bend: about(45), side: about(25), twist: about(20) },
  toe: { stiffness: 4, bend: about(40), side: about(5), twist: about(5) },
  finger: { stiffness: 2, bend: [-10, 100], side: about(10), twist: about(5), fromStraight: true },
  thumb: { stiffness: 2, bend: about(50), side: about(30), twist: about(20) },
  twist: { stiffness: 8, bend: about(1), side: about(1), twist: about(90) },
};

/** The sides of the pelvis and of the shoulder girdle that a file has as joints hardly move. */
const sideOfPelvis: Habit = { stiffness: 10, bend: about(5), side: about(5), twist: about(5) };

/** A bend of the zero pose in degrees that tells nothing, and one that tells the plane alone. */
const [unclear, clear] = [10, 20];

const known = new WeakMap<Character, readonly JointNature[]>();

/**
 * Returns how the joints of a character move by nature, in the order of the joints; only those
 * whose role is clear. The same array comes each time.
 */
export function naturesOf(character: Character): readonly JointNature[] {
  let natures = known.get(character);
  if (!natures) {
    const body = bodyOf(character);
    natures = body.roles.flatMap((role, joint) => (role ? natureOf(body, joint, role) : []));
    known.set(character, natures);
  }
  return natures;
}

function natureOf(body: Body, joint: number, role: JointRole): JointNature[] {
  const along = new Float64Array(3);
  vec3.subtract(along, body.ends[joint]!, body.places[joint]!);
  const isTrunk = role === 'root' || (role === 'pelvis' && body.sides[joint] === null);
  if (isTrunk || vec3.length(along) < 1e-9) along.set(body.up);
  vec3.normalize(along, along);
  const axis = bendAxis(body, joint, role, along);
  if (!axis) return [];
  const isSide = role === 'pelvis' && body.sides[joint] !== null;
  const habit = isSide ? sideOfPelvis : habits[role];
  const bent = habit.fromStraight ? bendAngle(body, joint, axis, along) : 0;
  // A file may stand bent farther than a body likes; where it stands is always allowed.
  const bend: Range = [
    Math.min(radians(habit.bend[0]) - bent, 0),
    Math.max(radians(habit.bend[1]) - bent, 0),
  ];
  const side = role === 'hip' && body.sides[joint] === 'left' ? mirrored(habit.side) : habit.side;
  return [
    {
      joint,
      stiffness: habit.stiffness,
      jointFromNature: jointFromAxes(body, joint, axis, along),
      bend,
      side: [radians(side[0]), radians(side[1])],
      twist: [radians(habit.twist[0]), radians(habit.twist[1])],
    },
  ];
}

/**
 * The axis of bending as a unit vector at a right angle to the limb, so that a positive angle bends
 * in the usual way. Where the limb stands bent, that tells the plane; a straight elbow, hip or
 * finger bends forward, a knee backward. Null where an elbow's or a knee's plane is unknown.
 */
function bendAxis(body: Body, joint: number, role: JointRole, along: vec3): vec3 | null {
  const axis = new Float64Array(3);
  const toward = body.forward ?? [0, 0, 1];
  vec3.cross(axis, along, role === 'knee' ? vec3.scale(new Float64Array(3), toward, -1) : toward);
  if (role === 'finger' || role === 'thumb') return square(curlAxis(body, joint, along), along);
  if (role === 'elbow' || role === 'knee') {
    const above = limbAbove(body, joint);
    const bent = above ? vec3.cross(new Float64Array(3), above, along) : new Float64Array(3);
    const degrees = above ? (angleBetween(above, along) * 180) / Math.PI : 0;
    if (!body.forward && degrees < clear) return null;
    const t = Math.min(Math.max((degrees - unclear) / (clear - unclear), 0), 1);
    const trust = t * t * (3 - 2 * t);
    if (vec3.length(bent) > 1e-9) vec3.normalize(bent, bent);
    if (vec3.length(axis) > 1e-9) vec3.normalize(axis, axis);
    vec3.scale(axis, axis, 1 - trust);
    vec3.scaleAndAdd(axis, axis, bent, trust);
  }
  return square(axis, along);
}

/** The part of an axis at a right angle to the limb; any such axis where it has none. */
function square(axis: vec3, along: vec3): vec3 {
  const part = vec3.scaleAndAdd(new Float64Array(3), axis, along, -vec3.dot(axis, along));
  if (vec3.length(part) < 1e-6) {
    const sizes = [Math.abs(along[0]), Math.abs(along[1]), Math.abs(along[2])];
    const other = new Float64Array(3);
    other[sizes.indexOf(Math.min(...sizes))] = 1;
    vec3.cross(part, along, other);
  }
  return vec3.normalize(part, part);
}

/** The direction of the limb that ends at a joint, without joints at the same place. */
function limbAbove({ skeleton, places }: Body, joint: number): vec3 | null {
  for (let at = skeleton.parents[joint]!; at >= 0; at = skeleton.parents[at]!) {
    const above = vec3.subtract(new Float64Array(3), places[joint]!, places[at]!);
    if (vec3.length(above) > 1e-8) return vec3.normalize(above, above);
  }
  return null;
}

/** How far a limb stands bent about its axis, in radians. */
function bendAngle(body: Body, joint: number, axis: vec3, along: vec3): number {
  const above = limbAbove(body, joint);
  if (!above) return 0;
  const across = vec3.cross(new Float64Array(3), axis, along);
  return Math.atan2(-vec3.dot(above, across), vec3.dot(above, along));
}

/** The unit quaternion from the axes x = `axis`, z = `along` to the joint's frame. */
function jointFromAxes(
  body: Body,
  joint: number,
  axis: vec3,
  along: vec3,
): JointNature['jointFromNature'] {
  const across = vec3.cross(new Float64Array(3), along, axis);
  const characterFromNature = mat3.fromValues(
    ...([...axis, ...across, ...along] as Parameters<typeof mat3.fromValues>),
  );
  const characterFromJoint = mat3.fromMat4(
    new Float64Array(9),
    body.matrices.subarray(joint * 16, joint * 16 + 16),
  );
  mat3.transpose(characterFromJoint, characterFromJoint);
  const rotation = mat3.multiply(new Float64Array(9), characterFromJoint, characterFromNature);
  const q = quat.fromMat3(new Float64Array(4), rotation);
  quat.normalize(q, q);
  return [q[0], q[1], q[2], q[3]];
}

function mirrored([low, high]: Range): Range {
  return [-high, -low];
}

function radians(degrees: number): number {
  return (degrees * Math.PI) / 180;
}
