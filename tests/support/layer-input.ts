import type { LayerPose, LayerUse, PoseContext } from '../../src/posing/pose-layer.ts';

/**
 * The input of a pose layer for values of q, at time 0 and without a clip.
 *
 * @param q (qCount) written by the layer
 */
export function layerInput(use: LayerUse, q: Float64Array): [PoseContext, LayerPose] {
  const morphWeights = new Float64Array(use.character.morphs.length);
  const context = { ...use, clip: null, time: 0, followed: null, unkeyed: null, morphWeights };
  return [
    { ...context, q: q.slice() },
    { q, morphWeights, pins: use.pins },
  ];
}
