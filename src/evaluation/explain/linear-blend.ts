import type { Skin } from '../../core/skin.ts';
import type { Evaluation } from '../evaluation.ts';
import { axes, blendOf, ghostsOf, pointOf, scaled } from './entry-motions.ts';
import type { Explain, Explanation } from './explanation.ts';

/** Linear blend: the weighted places to which single joints would take the point. */
export const explainLinearBlend: Explain = (evaluation, point) =>
  linearBlendBy(evaluation, point, evaluation.skin);

/** @param skin has the weights that are used */
export function linearBlendBy(evaluation: Evaluation, point: number, skin: Skin): Explanation {
  const ghosts = ghostsOf(evaluation, point, skin);
  const place = blendOf(ghosts);
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
        rows: ghosts.map((ghost) => ({
          of: ghost.entry,
          values: scaled(ghost.place, ghost.weight),
        })),
        total: place,
      },
    ],
  };
}
