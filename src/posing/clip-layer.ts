import { clipFor, evaluateClip } from '../core/clip.ts';
import type { LayerFunction } from './pose-layer.ts';

/**
 * Sets the values that the bound clip animates, at its time; other values keep their edited state.
 */
export const applyClip: LayerFunction = ({ character, clip, time }, q) => {
  if (clip) evaluateClip(clipFor(clip, character.skeleton), time, q);
};
