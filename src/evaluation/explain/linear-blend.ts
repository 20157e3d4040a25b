import { axes, ghostsOf, pointOf, scaled, sumOfVectors } from './entry-motions.ts';
import type { Explain } from './explanation.ts';

/** Linear blend: the weighted places to which single joints would take the point. */
export const explainLinearBlend: Explain = (evaluation, point) => {
  const ghosts = ghostsOf(evaluation, point);
  const terms = ghosts.map(({ weight, place }) => scaled(place, weight));
  const place = sumOfVectors(terms);
  return {
    rest: pointOf(evaluation.rest.positions, point),
    ...{ place, ghosts, marks: [] },
    steps: [
      {
        title: 'T·B⁻¹·p, where each joint would take it alone',
        columns: axes,
        rows: ghosts.map(({ entry, place: values }) => ({ of: entry, values })),
        total: null,
      },
      {
        title: 'w·T·B⁻¹·p, and their sum: the vertex',
        columns: axes,
        rows: ghosts.map(({ entry }, i) => ({ of: entry, values: terms[i]! })),
        total: place,
      },
    ],
  };
};
