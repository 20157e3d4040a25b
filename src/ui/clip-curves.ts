import { evaluateChannel } from '../core/motion/channel.ts';
import type { Clip } from '../core/motion/clip.ts';
import { axisDofs } from '../core/pose.ts';
import { DofKind, type Skeleton } from '../core/skeleton.ts';

/**
 * A point of a curve: the time in seconds, and the height relative to the range of its kind of
 * value.
 */
interface CurvePoint {
  readonly time: number;
  /** From 0 to 1. */
  readonly part: number;
}

/** A clip's curve for one degree of freedom, ready to be drawn. */
export interface Curve {
  /** "X", or "Move X". */
  readonly name: string;
  readonly axis: 'x' | 'y' | 'z';
  readonly isAngle: boolean;
  readonly samples: readonly CurvePoint[];
  /** The keys within the range that is played. */
  readonly keys: readonly CurvePoint[];
}

const sampleCount = 160;

/**
 * The curves of a joint's degrees of freedom. Angles and translations each have a scale of their
 * own.
 */
export function clipCurves(clip: Clip, skeleton: Skeleton, joint: number): readonly Curve[] {
  const { start, end, curves } = clip;
  if (joint < 0) return [];
  const dofs = axisDofs(skeleton, joint)
    .map((dof) => ({ ...dof, channel: curves.q.find(({ index }) => index === dof.index)?.channel }))
    .sort((a, b) => a.kind - b.kind || a.axis - b.axis);
  const times = Array.from(
    { length: sampleCount + 1 },
    (_, i) => start + ((end - start) * i) / sampleCount,
  );
  return dofs.flatMap(({ kind, axis, channel }) => {
    if (!channel) return [];
    const same = dofs.flatMap((other) => (other.kind === kind ? (other.channel ?? []) : []));
    const values = same.flatMap((each) => times.map((time) => evaluateChannel(each, time)));
    const low = values.reduce((least, value) => Math.min(least, value), Infinity);
    const high = values.reduce((most, value) => Math.max(most, value), -Infinity);
    const pointAt = (time: number): CurvePoint => ({
      time,
      part: high > low ? (evaluateChannel(channel, time) - low) / (high - low) : 0.5,
    });
    const letter = (['x', 'y', 'z'] as const)[axis];
    const isAngle = kind === DofKind.hinge;
    return {
      name: `${isAngle ? '' : 'Move '}${letter.toUpperCase()}`,
      axis: letter,
      isAngle,
      samples: times.map(pointAt),
      keys: [...channel.times].filter((time) => time >= start && time <= end).map(pointAt),
    };
  });
}
