import { axisDofs } from '../pose.ts';
import { DofKind } from '../skeleton.ts';
import {
  type ChannelParts,
  type ClipParts,
  type Extrapolation,
  isRotationChannel,
  type Quaternion,
  type RotationChannelParts,
  type RotationCurve,
  type ScalarChannelParts,
  type Tangent,
} from './clip-parts.ts';
import { clipFor, evaluateClip } from './clip.ts';
import { sameTime } from './edit/keys.ts';
import { jointRotation } from './joint-rotation.ts';
import { turnAngle } from './quaternions.ts';
import { rotationTrack } from './rotation-track.ts';
import type { AnimatedThing } from './targets.ts';

/** How a joint's rotation is stored: a curve for each of three hinges, or one of quaternions. */
export type RotationForm = 'euler' | RotationCurve;

export interface ConvertedRotation {
  readonly clip: ClipParts;
  /** The largest angle between the rotation before and after, in radians. */
  readonly difference: number;
  /** Where it is, in seconds. */
  readonly time: number;
}

/** Into how many pieces a span between keys is divided to find the largest difference. */
const pieces = 32;

/**
 * Stores the rotation of a joint in another form, with keys at the times of all its keys. They lie
 * on the curves as they were; in between the curve is another one, and the largest difference is
 * measured, over the keys and the clip's range. Curves of angles are linear where they were a
 * slerp, and smooth where they were a squad.
 *
 * @param source file index of the joint
 * @param q (qCount) what hinges without a curve have
 * @returns null if the joint can't take the form: 'euler' needs three hinges about the coordinate
 *   axes, the others those or a ball
 */
export function convertRotation(
  clip: ClipParts,
  thing: AnimatedThing,
  source: number,
  form: RotationForm,
  q: Float64Array,
): ConvertedRotation | null {
  const joint = thing.skeleton.jointOfSource[source];
  if (joint === undefined) return null;
  const track = rotationTrack(emptyRotation(source, 'slerp'), thing.skeleton);
  if (!track || (form === 'euler' && !track.hinges)) return null;
  const own = clip.channels.filter((channel) => isTurnOf(channel, source));
  const isStored = own.every((each) => formOf(each) === form);
  if (isStored) return { clip, difference: 0, time: clip.start };
  const before = motionOf({ ...clip, channels: own }, thing, joint, q);
  const times = keyTimes(own);
  const made: readonly ChannelParts[] =
    form === 'euler'
      ? angleCurves(own, times, before, thing, joint, source)
      : [rotationCurve(own, times, before, source, form)];
  const after = motionOf({ ...clip, channels: made }, thing, joint, q);
  const first = clip.channels.indexOf(own[0]!);
  const channels = clip.channels.flatMap((channel, at) => {
    if (at === first) return made;
    return own.includes(channel) ? [] : [channel];
  });
  return { clip: { ...clip, channels }, ...largestDifference(before, after, times, clip) };
}

/** Whether a channel turns a joint. */
function isTurnOf({ target }: ChannelParts, source: number): boolean {
  if (target?.of === 'rotation') return target.joint === source;
  return target?.of === 'value' && target.joint === source && target.kind === DofKind.hinge;
}

function formOf(channel: ChannelParts): RotationForm {
  return isRotationChannel(channel) ? channel.target.curve : 'euler';
}

function keyTimes(channels: readonly ChannelParts[]): readonly number[] {
  const all = channels.flatMap(({ keys }) => keys.map(({ time }) => time)).sort((a, b) => a - b);
  return all.filter((time, at) => at === 0 || !sameTime(time, all[at - 1]!));
}

/** What some channels make of a joint. */
interface JointMotion {
  /** (4) of the time that was asked for last. */
  readonly rotation: Float64Array;
  /** Returns the pose (qCount) at a time, always the same array, and sets the rotation. */
  at(time: number): Float64Array;
}

function motionOf(
  clip: ClipParts,
  thing: AnimatedThing,
  joint: number,
  q: Float64Array,
): JointMotion {
  const compiled = clipFor(clip, thing);
  const [morphWeights, pins] = [new Float64Array(0), new Float64Array(0)];
  const values = { q: q.slice(), morphWeights, pins };
  const rotation = new Float64Array(4);
  return {
    rotation,
    at(time) {
      evaluateClip(compiled, time, values);
      jointRotation(thing.skeleton, joint, values.q, rotation);
      return values.q;
    },
  };
}

function rotationCurve(
  own: readonly ChannelParts[],
  times: readonly number[],
  motion: JointMotion,
  source: number,
  curve: RotationCurve,
): RotationChannelParts {
  const keys = times.map((time) => {
    motion.at(time);
    const [x, y, z, w] = motion.rotation;
    const value: Quaternion = [x!, y!, z!, w!];
    return { time, value };
  });
  return { ...emptyRotation(source, curve), ...rulesOf(own), keys };
}

function emptyRotation(joint: number, curve: RotationCurve): RotationChannelParts {
  return {
    target: { of: 'rotation', joint, curve },
    before: 'constant',
    after: 'constant',
    keys: [],
  };
}

function angleCurves(
  own: readonly ChannelParts[],
  times: readonly number[],
  motion: JointMotion,
  { skeleton }: AnimatedThing,
  joint: number,
  source: number,
): readonly ScalarChannelParts[] {
  const hinges = axisDofs(skeleton, joint).filter(({ kind }) => kind === DofKind.hinge);
  const poses = times.map((time) => motion.at(time).slice());
  const tangent: Tangent = own.some((each) => formOf(each) === 'squad') ? 'smooth' : 'linear';
  return hinges.map(({ kind, axis, index }) => ({
    target: { of: 'value', joint: source, kind, axis },
    ...rulesOf(own),
    keys: times.map((time, at) => {
      const value = poses[at]![index]!;
      return { time, value, tangentIn: tangent, tangentOut: tangent };
    }),
  }));
}

/** How the first of some channels continues outside its keys. */
function rulesOf([first]: readonly ChannelParts[]): {
  readonly before: Extrapolation;
  readonly after: Extrapolation;
} {
  return { before: first?.before ?? 'constant', after: first?.after ?? 'constant' };
}

function largestDifference(
  before: JointMotion,
  after: JointMotion,
  times: readonly number[],
  { start, end }: ClipParts,
): { readonly difference: number; readonly time: number } {
  const ends = [start, ...times, end].sort((a, b) => a - b);
  let largest = { difference: 0, time: start };
  ends.slice(1).forEach((to, span) => {
    const from = ends[span]!;
    for (let i = 0; i <= pieces; i++) {
      const time = from + ((to - from) * i) / pieces;
      before.at(time);
      after.at(time);
      const difference = turnAngle(before.rotation, after.rotation);
      if (difference > largest.difference) largest = { difference, time };
    }
  });
  return largest;
}
