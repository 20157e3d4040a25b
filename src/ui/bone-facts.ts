import { type BoneFrame, boneFrames } from '../core/bone-frames.ts';
import { boneWeights } from '../core/bone-weights.ts';
import type { Character } from '../core/character.ts';
import type { Skeleton } from '../core/skeleton.ts';

/** All bones of a skeleton; kept. */
export function framesOf(skeleton: Skeleton): readonly BoneFrame[] {
  let frames = knownFrames.get(skeleton);
  if (!frames) knownFrames.set(skeleton, (frames = boneFrames(skeleton)));
  return frames;
}

/** The bones that a joint turns; of a joint without child the one that ends at it. Index among all. */
export function bonesAt(frames: readonly BoneFrame[], joint: number): number[] {
  const withEnd = (end: 'source' | 'destination'): number[] =>
    frames.flatMap((frame, bone) => (frame[end] === joint ? [bone] : []));
  const starting = withEnd('source');
  return starting.length > 0 ? starting : withEnd('destination');
}

/** How many vertices a bone has a weight for. */
export function weighedCount({ skeleton, skin }: Character, bone: number): number {
  const frames = framesOf(skeleton);
  let starts = knownStarts.get(frames);
  if (!starts) knownStarts.set(frames, (starts = boneWeights(frames, skin).start));
  return starts[bone + 1]! - starts[bone]!;
}

const knownFrames = new WeakMap<Skeleton, readonly BoneFrame[]>();
const knownStarts = new WeakMap<readonly BoneFrame[], Uint32Array>();
