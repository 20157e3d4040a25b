import { DofKind, type Skeleton } from '../skeleton.ts';
import type { RotationChannelParts } from './clip-parts.ts';
import { keepWithin } from './hinge-limits.ts';
import { type HingePath, hingePath, writeHingeAngles } from './hinge-path.ts';
import { evaluateRotation, type RotationChannel, rotationChannelFor } from './rotation-channel.ts';

/** A curve of rotations, and where its values stand in q: in a ball or in three hinges. */
export interface RotationTrack {
  readonly channel: RotationChannel;
  /** (4) the indices in q of a ball's values, or (3) of the hinges' in the order of their product. */
  readonly indices: Uint32Array;
  readonly hinges: HingeTrack | null;
  /** (4) the rotation that was evaluated last, and (3) the angles of its hinges. */
  readonly rotation: Float64Array;
  readonly angles: Float64Array;
}

interface HingeTrack {
  readonly path: HingePath;
  /** (3) radians. */
  readonly minima: Float64Array;
  readonly maxima: Float64Array;
}

/** Returns null if the skeleton does not have the joint, or the joint can't take a rotation. */
export function rotationTrack(
  parts: RotationChannelParts,
  skeleton: Skeleton,
): RotationTrack | null {
  const joint = skeleton.jointOfSource[parts.target.joint];
  if (joint === undefined) return null;
  const turning = turningDofs(skeleton, joint);
  const channel = rotationChannelFor(parts);
  const room = { channel, rotation: new Float64Array(4), angles: new Float64Array(3) };
  const ball = turning.find((dof) => skeleton.dofKind[dof] === DofKind.ball);
  if (ball !== undefined) {
    const first = skeleton.dofQ[ball]!;
    return {
      ...room,
      indices: Uint32Array.of(first, first + 1, first + 2, first + 3),
      hinges: null,
    };
  }
  const [a, b, c] = turning.map((dof) =>
    skeleton.dofAxis.subarray(dof * 3, dof * 3 + 3).indexOf(1),
  );
  const isTriple = turning.length === 3 && [0, 1, 2].every((axis) => [a, b, c].includes(axis));
  if (!isTriple) return null;
  const indices = Uint32Array.from(turning, (dof) => skeleton.dofQ[dof]!);
  const minima = Float64Array.from(indices, (index) => skeleton.qMin[index]!);
  const maxima = Float64Array.from(indices, (index) => skeleton.qMax[index]!);
  const hinges = { path: hingePath(channel, [a!, b!, c!]), minima, maxima };
  return { ...room, indices, hinges };
}

/** A joint's balls and hinges, in stored order. */
function turningDofs({ dofStart, dofKind }: Skeleton, joint: number): number[] {
  const found: number[] = [];
  for (let dof = dofStart[joint]!; dof < dofStart[joint + 1]!; dof++) {
    if (dofKind[dof] !== DofKind.slide) found.push(dof);
  }
  return found;
}

/** Writes the joint's values at a time, the angles of hinges within their limits. */
export function evaluateTrack(
  { channel, indices, hinges, rotation, angles }: RotationTrack,
  time: number,
  q: Float64Array,
): void {
  evaluateRotation(channel, time, rotation);
  if (!hinges) {
    for (let i = 0; i < 4; i++) q[indices[i]!] = rotation[i]!;
    return;
  }
  writeHingeAngles(hinges.path, channel, time, rotation, angles);
  keepWithin(angles, hinges.minima, hinges.maxima);
  for (let i = 0; i < 3; i++) q[indices[i]!] = angles[i]!;
}
