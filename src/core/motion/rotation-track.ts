import { DofKind, type Skeleton } from '../skeleton.ts';
import type { RotationChannelParts } from './clip-parts.ts';
import { evaluateRotation, type RotationChannel, rotationChannelFor } from './rotation-channel.ts';

/** A curve of rotations, and where its values stand in q. */
export interface RotationTrack {
  readonly channel: RotationChannel;
  /** The first of the four values of a ball. */
  readonly ball: number;
  /** (4) the rotation that was evaluated last. */
  readonly rotation: Float64Array;
}

/** Returns null if the skeleton does not have the joint, or the joint can't take a rotation. */
export function rotationTrack(
  parts: RotationChannelParts,
  skeleton: Skeleton,
): RotationTrack | null {
  const joint = skeleton.jointOfSource[parts.target.joint];
  if (joint === undefined) return null;
  const dofs = [
    ...skeleton.dofKind.subarray(skeleton.dofStart[joint], skeleton.dofStart[joint + 1]),
  ];
  const ball = dofs.indexOf(DofKind.ball);
  if (ball < 0) return null;
  return {
    channel: rotationChannelFor(parts),
    ball: skeleton.dofQ[skeleton.dofStart[joint]! + ball]!,
    rotation: new Float64Array(4),
  };
}

/** Writes the joint's values at a time. */
export function evaluateTrack(track: RotationTrack, time: number, q: Float64Array): void {
  evaluateRotation(track.channel, time, track.rotation);
  for (let i = 0; i < 4; i++) q[track.ball + i] = track.rotation[i]!;
}
