import type { ClipValues } from '../../src/core/motion/clip.ts';
import type { AnimatedThing } from '../../src/core/motion/targets.ts';

/** The file's pose, for a clip to write into. */
export function clipValues({ skeleton, morphs }: AnimatedThing): ClipValues {
  return {
    q: skeleton.qRest.slice(),
    morphWeights: new Float64Array(morphs.length),
    pins: new Float64Array(skeleton.jointCount * 4),
  };
}
