import { evaluateClip } from '../core/clip.ts';
import type { PoseLayer } from './pose-layer.ts';

/**
 * Sets the values that the bound clip animates, at its time; other values keep their edited state.
 */
export const clipLayer: PoseLayer = {
  id: 'clip',
  isActive: ({ clip }) => clip !== null,
  apply({ clip, time }, q) {
    if (clip) evaluateClip(clip, time, q);
  },
};
