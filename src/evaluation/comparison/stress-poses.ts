import { mat3, quat, type ReadonlyVec3, vec3 } from 'gl-matrix';
import type { Character } from '../../core/character.ts';
import { axisDofs, jointRange } from '../../core/pose.ts';
import type { Skeleton } from '../../core/skeleton.ts';
import type { Skin } from '../../core/skin.ts';
import type { Vector3 } from '../../posing/ik/problem.ts';
import { naturesOf } from '../../posing/natural/natures.ts';
import { bendAxis, limbEnd } from '../../posing/telling-poses.ts';
import {
  takesAnyTurn,
  turnAbout,
  turnJoint,
  type TurnStart,
  turnStart,
} from '../../posing/turn-joint.ts';
import { deformingJoints } from './deforming-joints.ts';

/** A pose in which one joint is turned to an end of its range. */
export interface StressPose {
  readonly joint: number;
  /** How it turns: "bend", "side" or "twist", or the name of a hinge's axis. */
  readonly motion: string;
  /** In radians: how far it turns, or the value of the hinge. */
  readonly angle: number;
  /** The axis of the turn, a unit vector in the joint's frame; the turn leaves it in place. */
  readonly axis: Vector3;
  /** (qCount) */
  readonly q: Float64Array;
}

/** How far joints without limits turn at most, in radians. */
export interface StressRanges {
  /** About axes across the bone, to each side. */
  readonly bend: number;
  /** About the bone, to each side. */
  readonly twist: number;
}

const degree = Math.PI / 180;
export const usualRanges: StressRanges = { bend: 120 * degree, twist: 90 * degree };

/** An end of a range that is nearer to rest is no stress. */
const leastAngle = 8 * degree;
/** A hinge whose axis has this cosine with the bone twists it. */
const along = 0.8;

/**
 * Returns the poses that put a skin under stress: each joint that deforms it, one at a time, turned to
 * both ends of its range while all others stay. A hinge with limits has these for its range. A joint
 * that can turn freely bends about two axes across its bone and twists about it, as far as the joints
 * of a body do by nature where it is one, and no farther than the ranges.
 *
 * @param q (qCount) the pose from which joints turn; the one that turns starts where the file has it
 */
export function stressPoses(
  character: Character,
  skin: Skin,
  q: Float64Array,
  ranges: StressRanges = usualRanges,
): StressPose[] {
  const { skeleton } = character;
  return deformingJoints(skeleton, skin).flatMap((joint) => {
    // Where the joints above it are does not matter to the values of a joint.
    const start = turnStart(skeleton, joint, skeleton.qRest);
    const turns = isFree(start)
      ? freeTurns(character, start, ranges)
      : hingeTurns(character, start, ranges);
    const [from, to] = jointRange(skeleton, joint);
    return turns.map(({ motion, angle, axis, turned }): StressPose => {
      const posed = q.slice();
      posed.set(turned.subarray(from, to), from);
      return { joint, motion, angle, axis: inJoint(start, axis), q: posed };
    });
  });
}

/** A turn of one joint from the file's pose. */
interface Turn extends Pick<StressPose, 'motion' | 'angle'> {
  /** In the character's space. */
  readonly axis: vec3;
  /** (qCount) */
  readonly turned: Float64Array;
}

/** Whether a joint has neither limits nor directions in which it can't turn. */
function isFree(start: TurnStart): boolean {
  const { qMin, qMax } = start.skeleton;
  return (
    takesAnyTurn(start) &&
    start.free.every(({ index }) => qMin[index] === -Infinity && qMax[index] === Infinity)
  );
}

function freeTurns(character: Character, start: TurnStart, ranges: StressRanges): Turn[] {
  const nature = naturesOf(character).find(({ joint }) => joint === start.joint);
  const { bend, side, twist } = axesOf(character, start);
  const ends = (range: readonly [number, number] | undefined, most: number): number[] => {
    const [low, high] = range ?? [-most, most];
    return [Math.min(high, most), Math.max(low, -most)];
  };
  const motions = [
    { motion: 'bend', axis: bend, angles: ends(nature?.bend, ranges.bend) },
    { motion: 'side', axis: side, angles: ends(nature?.side, ranges.bend) },
    { motion: 'twist', axis: twist, angles: ends(nature?.twist, ranges.twist) },
  ];
  return motions.flatMap(({ motion, axis, angles }) =>
    angles
      .filter((angle) => Math.abs(angle) >= leastAngle)
      .map((angle): Turn => {
        const turned = turnJoint(start, turnAbout(axis, angle), start.q);
        return { motion, angle, axis, turned };
      }),
  );
}

/** The axes of a free joint, unit vectors in the character's space. */
function axesOf(character: Character, start: TurnStart): Record<'bend' | 'side' | 'twist', vec3> {
  const nature = naturesOf(character).find(({ joint }) => joint === start.joint);
  const bone = boneOf(character, start);
  const hasBone = vec3.length(bone) > 0;
  const jointFromAxes = quat.fromValues(...(nature?.jointFromNature ?? [0, 0, 0, 1]));
  const [bend, twist] = ([[1, 0, 0], nature ? [0, 0, 1] : [0, 1, 0]] as const).map((axis) =>
    inCharacter(start, vec3.transformQuat(new Float64Array(3), axis, jointFromAxes)),
  ) as [vec3, vec3];
  if (!nature && hasBone) {
    vec3.copy(twist, bone);
    vec3.copy(bend, bendAxis(character, start.joint, start));
  }
  vec3.normalize(twist, twist);
  vec3.scaleAndAdd(bend, bend, twist, -vec3.dot(bend, twist));
  vec3.normalize(bend, bend);
  return { bend, side: vec3.cross(new Float64Array(3), twist, bend), twist };
}

function hingeTurns(character: Character, start: TurnStart, ranges: StressRanges): Turn[] {
  const { skeleton, q } = start;
  const bone = boneOf(character, start);
  vec3.normalize(bone, bone);
  return start.free.flatMap(({ axis, index }, order) => {
    const rest = q[index]!;
    const most = Math.abs(vec3.dot(axis, bone)) > along ? ranges.twist : ranges.bend;
    const [low, high] = [skeleton.qMin[index]!, skeleton.qMax[index]!];
    const ends = [
      high === Infinity ? Math.max(rest, low) + most : high,
      low === -Infinity ? Math.min(rest, high) - most : low,
    ];
    return ends
      .filter((angle) => Math.abs(angle - rest) >= leastAngle)
      .map((angle): Turn => {
        const turned = q.slice();
        turned[index] = angle;
        const motion = hingeName(skeleton, start.joint, index) ?? `axis ${order + 1}`;
        return { motion, angle, axis, turned };
      });
  });
}

function hingeName(skeleton: Skeleton, joint: number, value: number): string | undefined {
  const dof = axisDofs(skeleton, joint).find(({ index }) => index === value);
  return dof && ['X', 'Y', 'Z'][dof.axis];
}

/** The bone of a joint in the character's space; zero if it has none. */
function boneOf(character: Character, start: TurnStart): vec3 {
  return inCharacter(start, limbEnd(character, start.joint));
}

/** A direction of the joint's frame in the character's space. */
function inCharacter({ frames }: TurnStart, direction: ReadonlyVec3): vec3 {
  const rotation = mat3.fromMat4(new Float64Array(9), frames.characterFromJoint);
  return vec3.transformMat3(new Float64Array(3), direction, rotation);
}

/** The opposite, for a unit vector. */
function inJoint({ frames }: TurnStart, direction: ReadonlyVec3): Vector3 {
  const rotation = mat3.fromMat4(new Float64Array(9), frames.characterFromJoint);
  mat3.transpose(rotation, rotation);
  const own = vec3.transformMat3(new Float64Array(3), direction, rotation);
  vec3.normalize(own, own);
  return [own[0], own[1], own[2]];
}
