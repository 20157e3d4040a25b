import { type BoneFrame, boneFrames } from '../core/bone-frames.ts';
import { boneWeights } from '../core/bone-weights.ts';
import type { Character } from '../core/character.ts';
import type { Skeleton } from '../core/skeleton.ts';

/** All bones of a skeleton; computed once per skeleton. */
export function framesOf(skeleton: Skeleton): readonly BoneFrame[] {
  let frames = knownFrames.get(skeleton);
  if (!frames) knownFrames.set(skeleton, (frames = boneFrames(skeleton)));
  return frames;
}

/**
 * The indices of the bones that a joint rotates; for a joint without a child, of the bone that ends
 * at it.
 */
export function bonesAt(frames: readonly BoneFrame[], joint: number): number[] {
  const withEnd = (end: 'source' | 'destination'): number[] =>
    frames.flatMap((frame, bone) => (frame[end] === joint ? [bone] : []));
  const starting = withEnd('source');
  return starting.length > 0 ? starting : withEnd('destination');
}

/** The number of vertices for which a bone has a weight. */
export function weighedCount({ skeleton, skin }: Character, bone: number): number {
  const frames = framesOf(skeleton);
  let starts = knownStarts.get(frames);
  if (!starts) knownStarts.set(frames, (starts = boneWeights(frames, skin).start));
  return starts[bone + 1]! - starts[bone]!;
}

const knownFrames = new WeakMap<Skeleton, readonly BoneFrame[]>();
const knownStarts = new WeakMap<readonly BoneFrame[], Uint32Array>();
