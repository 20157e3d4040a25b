import type { Character } from '../core/character.ts';
import type { Diagnostic } from '../core/diagnostics.ts';
import { clipFor, evaluateClip } from '../core/motion/clip.ts';
import type { ChannelParts, ClipParts, RotationKeyParts } from '../core/motion/clip-parts.ts';
import { evaluateRotation, rotationChannelFor } from '../core/motion/rotation-channel.ts';
import { DofKind } from '../core/skeleton.ts';
import { firstRoot } from '../core/subtree.ts';
import { lost } from './lost.ts';
import { frameTimes } from './motion/frame-times.ts';
import { atMost, largestBetween } from './motion/largest-between.ts';
import { type MovedJoints, movedJoints, type Window, windowOf } from './motion/moved-joints.ts';
import { sampleAngles, smoothKeys } from './motion/sampled-angles.ts';
import { type Angles, turnBetween, turnOf } from './motion/turns.ts';
import { type SolvedPose, solvePose, type Target } from './solve-pose.ts';

export interface ConvertedClip {
  readonly clip: ClipParts;
  /** With an error, the motion of the joints is left out. */
  readonly losses: readonly Diagnostic[];
}

/** Two characters, and how the first becomes the second. */
export interface Conversion {
  readonly from: Character;
  readonly to: Character;
  readonly target: Target;
  /** (qCount) of the first, the values that a clip does not move. */
  readonly q: Float64Array;
}

/**
 * Converts a clip to the joints of a converted character. Equal angles are other rotations there, so
 * the joints that it moves are sampled at frames and solved again. Morphs, pins and what could not
 * be read stay.
 */
export function convertClip(clip: ClipParts, conversion: Conversion): ConvertedClip {
  const { from, to, target } = conversion;
  const losses: Diagnostic[] = [];
  const lose = (expected: string, found: string, effect: string): void => {
    losses.push(lost(clip.name, expected, found, effect));
  };
  const { kept, leftOut } = unturned(clip, to.morphs.length, Number(target.insertRoot));
  if (leftOut > 0) lose('channels of what the files hold', `${leftOut} of morphs`, 'left out');
  const moved = movedJoints(clip, from.skeleton);
  if (moved.otherSlides > 0) {
    lose('slides of the root', `${moved.otherSlides} of other joints`, 'left out');
  }
  if (moved.joints.length === 0 && !moved.root) {
    return { clip: { ...clip, channels: kept }, losses };
  }
  const window = windowOf(clip);
  const times = frameTimes([window.start, window.end], clip.fps, moved.times);
  if (!times) {
    const refusal = lost(clip.name, 'a motion of fewer frames', 'a longer one', 'it is left out');
    losses.push({ ...refusal, severity: 'error' });
    return { clip: { ...clip, channels: kept }, losses };
  }
  const { channels, largest } = sampleJoints(clip, conversion, { moved, window, times });
  const degrees = atMost((largest * 180) / Math.PI);
  const frames = `sampled at ${clip.fps} frames a second and solved again`;
  const effect = `${frames}; off by at most ${degrees}° between them`;
  lose('the same values of joints', `${moved.joints.length} joints with others`, effect);
  if (window.isCut) {
    const found = 'several, or ones that depend on values';
    lose('one rule outside the keys of all joints', found, 'the first and the last value hold');
  }
  return { clip: { ...clip, channels: [...kept, ...channels] }, losses };
}

/** The channels that do not depend on how joints turn. */
function unturned({ channels }: ClipParts, morphCount: number, shift: number) {
  const kept: ChannelParts[] = [];
  let leftOut = 0;
  for (const channel of channels) {
    const { target } = channel;
    if (target?.of === 'morph' && target.morph >= morphCount) leftOut++;
    else if (target?.of === 'morph') kept.push(channel);
    else if (target?.of === 'pin') {
      kept.push({ ...channel, target: { ...target, joint: target.joint + shift } } as ChannelParts);
    }
  }
  return { kept, leftOut };
}

interface Samples {
  readonly moved: MovedJoints;
  readonly window: Window;
  readonly times: readonly number[];
}

function sampleJoints(
  clip: ClipParts,
  conversion: Conversion,
  { moved, window, times }: Samples,
): { readonly channels: readonly ChannelParts[]; readonly largest: number } {
  const { from, to, target } = conversion;
  const { before, after } = window;
  const solved = solver(clip, conversion);
  const channels: ChannelParts[] = [];
  let largest = 0;
  for (const joint of moved.joints) {
    const source = from.skeleton.sourceIndex[joint]! + Number(target.insertRoot);
    const anglesAt = (time: number): Angles => {
      const [x, y, z] = solved(time).angles.subarray(joint * 3);
      return [x!, y!, z!];
    };
    const turnAt = (time: number) => turnOf(anglesAt(time), target.product);
    if (target.turnsByBall) {
      const keys = times.map((time): RotationKeyParts => {
        const [x, y, z, w] = turnAt(time);
        return { time, value: [x!, y!, z!, w!] };
      });
      const turned = { of: 'rotation', joint: source, curve: 'slerp' } as const;
      const channel = { target: turned, before, after, keys };
      channels.push(channel);
      const rotation = rotationChannelFor(channel);
      const now = new Float64Array(4);
      const difference = largestBetween(times, (time) => {
        evaluateRotation(rotation, time, now);
        return turnBetween(turnAt(time), now);
      });
      largest = Math.max(largest, difference);
      continue;
    }
    const sampled = sampleAngles(turnAt, times, target.product, anglesAt(times[0]!));
    largest = Math.max(largest, sampled.largest);
    for (const axis of [0, 1, 2] as const) {
      const turned = { of: 'value', joint: source, kind: DofKind.hinge, axis } as const;
      channels.push({ target: turned, before, after, keys: sampled.keys[axis] });
    }
  }
  const root = to.skeleton.sourceIndex[firstRoot(to.skeleton)]!;
  const rows = moved.root ? times.map((time) => solved(time).root) : [];
  for (const axis of moved.root ? ([0, 1, 2] as const) : []) {
    const slid = { of: 'value', joint: root, kind: DofKind.slide, axis } as const;
    const keys = smoothKeys(
      times,
      rows.map((row) => row[axis]),
    );
    channels.push({ target: slid, before, after, keys });
  }
  return { channels, largest };
}

/** Solves all joints at a time; what was solved is remembered, because each joint asks for it. */
function solver(clip: ClipParts, { from, target, q }: Conversion): (time: number) => SolvedPose {
  const { skeleton, skin, morphs } = from;
  const compiled = clipFor(clip, from);
  const known = new Map<number, SolvedPose>();
  return (time) => {
    let found = known.get(time);
    if (found) return found;
    const values = {
      q: q.slice(),
      morphWeights: new Float64Array(morphs.length),
      pins: new Float64Array(skeleton.jointCount * 4),
    };
    evaluateClip(compiled, time, values);
    known.set(time, (found = solvePose(skeleton, skin, values.q, target)));
    return found;
  };
}
