import type { RestLayer } from './rest-layer.ts';

const { fround } = Math;

/**
 * Morph targets: `p = base + Σ s · offset`, and normals likewise (CSE169, project 2). Morphs are
 * added in order; those of weight 0 are skipped. Weights are usually 0 to 1, but may be any number;
 * float32.
 */
export const morphLayer: RestLayer = {
  id: 'morphs',
  key: (_, { morphWeights }) => [morphWeights],
  terms: ({ morphs }, { morphWeights }) =>
    morphs
      .map((morph, index) => ({ ...morph, weight: fround(morphWeights?.[index] ?? 0) }))
      .filter(({ weight }) => weight !== 0),
};
