import type { mat4 } from 'gl-matrix';
import { mat3, quat, type ReadonlyVec3, vec3 } from 'gl-matrix';
import { DofKind, type Skeleton } from '../core/skeleton.ts';
import { type HingeTriple, hingeTriple, tripleAngles } from './hinge-triple.ts';
import {
  type DofFrame,
  freeHinges,
  jointFrames,
  type JointFrames,
  parentMatrix,
  withinLimits,
} from './joint-frames.ts';

/** A joint at the start of a turn; all rotations are computed from it. */
export interface TurnStart {
  readonly skeleton: Skeleton;
  readonly joint: number;
  readonly q: Float64Array;
  readonly worldFromParent: mat4;
  readonly frames: JointFrames;
  /** The point about which it rotates: its origin, unless slides come after its hinges. */
  readonly pivot: vec3;
  /**
   * The degree of freedom that can take any rotation: a ball or three hinges; null if there is
   * neither.
   */
  readonly ball: DofFrame | null;
  readonly triple: HingeTriple | null;
  readonly free: readonly DofFrame[];
}

export function turnStart(
  skeleton: Skeleton,
  joint: number,
  q: Float64Array,
  worldFromParent = parentMatrix(skeleton, joint, q),
): TurnStart {
  const frames = jointFrames(skeleton, joint, q, worldFromParent);
  const ball = frames.dofs.find(({ kind }) => kind === DofKind.ball) ?? null;
  const first = ball ?? frames.dofs.find(({ kind }) => kind === DofKind.hinge);
  const [x, y, z] = Array.from(frames.characterFromJoint).slice(12);
  const origin: vec3 = [x!, y!, z!];
  return {
    ...{ skeleton, joint, q, worldFromParent, frames, ball },
    pivot: first?.origin ?? origin,
    triple: hingeTriple(frames, skeleton.dofAxis, skeleton.dofStart[joint]!),
    free: freeHinges(skeleton, frames),
  };
}

/** Whether limits alone keep the joint from any rotation: it has a ball, or three free hinges. */
export function takesAnyTurn({ ball, triple, free }: TurnStart): boolean {
  return ball !== null || (triple !== null && free.length === 3);
}

/**
 * Returns the values that rotate the joint by `turn` about its pivot, or null if its degrees of
 * freedom can't take an arbitrary rotation. Limits are ignored.
 *
 * @param turn unit quaternion xyzw, in the character's space
 * @param near (qCount) of the equivalent values those nearest to these are returned
 */
export function turnFreely(start: TurnStart, turn: quat, near: Float64Array): Float64Array | null {
  const q = start.q.slice();
  if (start.ball) {
    q.set(turnBall(start.ball, turn, start.q, near), start.ball.index);
    return q;
  }
  if (!start.triple) return null;
  const angles = tripleAngles(start.triple, turn, near);
  start.triple.hinges.forEach(({ index }, i) => (q[index] = angles[i]!));
  return q;
}

/**
 * Like `turnFreely`, within the limits. If the joint's hinges can't take the rotation, they take
 * the values that come nearest to it together (least squares of the rotation vector).
 */
export function turnJoint(start: TurnStart, turn: quat, near: Float64Array): Float64Array {
  const { skeleton, free, q } = start;
  const turned = takesAnyTurn(start) ? turnFreely(start, turn, near) : null;
  if (turned) return withinLimits(skeleton, start.joint, turned);
  const rest = rotationVector(turn);
  const next = q.slice();
  // Gauss-Seidel, because there are few axes and the order of the hinges must not matter.
  for (let sweep = 0; sweep < 64; sweep++) {
    for (const { axis, index } of free) {
      const before = next[index]!;
      const wanted = before + vec3.dot(rest, axis);
      next[index] = Math.min(Math.max(wanted, skeleton.qMin[index]!), skeleton.qMax[index]!);
      vec3.scaleAndAdd(rest, rest, axis, before - next[index]);
    }
  }
  return next;
}

/** The quaternion that rotates by `angle` about a unit axis. */
export function turnAbout(axis: vec3, angle: number): quat {
  return quat.setAxisAngle(new Float64Array(4), axis, angle);
}

/**
 * The smallest rotation that takes one direction to another; both are nonzero and need not be unit
 * vectors. Exact opposites rotate about `fallback`, or its component perpendicular to `from`.
 */
export function shortestTurn(from: ReadonlyVec3, to: ReadonlyVec3, fallback: ReadonlyVec3): quat {
  const [a, b] = [vec3.length(from), vec3.length(to)];
  const axis = vec3.cross(new Float64Array(3), from, to);
  const w = a * b + vec3.dot(from, to);
  // sin and 1 + cos of nearly opposite directions: both are nearly zero and their ratio is lost.
  if (Math.hypot(...axis, w) < 1e-9 * a * b) {
    vec3.scaleAndAdd(axis, fallback, from, -vec3.dot(fallback, from) / (a * a));
    return quat.normalize(new Float64Array(4), [axis[0], axis[1], axis[2], 0]);
  }
  return quat.normalize(new Float64Array(4), [axis[0], axis[1], axis[2], w]);
}

/** Of the two quaternions of a rotation, returns the one nearest to the present. */
function turnBall(ball: DofFrame, turn: quat, q: Float64Array, near: Float64Array): quat {
  // turn · F · b = F · (F⁻¹ · turn · F) · b: rotating its vector part takes a quaternion to another
  // frame.
  const dofFromWorld = mat3.fromMat4(new Float64Array(9), ball.worldFromDof);
  mat3.transpose(dofFromWorld, dofFromWorld);
  const vector = vec3.transformMat3(new Float64Array(3), [turn[0], turn[1], turn[2]], dofFromWorld);
  const own = q.slice(ball.index, ball.index + 4);
  const present = near.subarray(ball.index, ball.index + 4);
  const turned: quat = new Float64Array([vector[0], vector[1], vector[2], turn[3]]);
  quat.normalize(turned, quat.multiply(turned, turned, own));
  return quat.dot(turned, present) < 0 ? quat.scale(turned, turned, -1) : turned;
}

/** The axis times the angle; the angle is from 0 to π. */
function rotationVector(turn: quat): vec3 {
  const sign = turn[3] < 0 ? -1 : 1;
  const vector: vec3 = new Float64Array([turn[0] * sign, turn[1] * sign, turn[2] * sign]);
  const half = vec3.length(vector);
  if (half === 0) return vector;
  return vec3.scale(vector, vector, (2 * Math.atan2(half, turn[3] * sign)) / half);
}
