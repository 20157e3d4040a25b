import { evaluateClip } from '../core/clip.ts';
import type { PoseLayer } from './pose-layer.ts';

/** The values that the bound clip has at its time; others stay as they were edited. */
export const clipLayer: PoseLayer = {
  id: 'clip',
  isActive: ({ clip }) => clip !== null,
  apply({ clip, time }, q) {
    if (clip) evaluateClip(clip, time, q);
  },
};
