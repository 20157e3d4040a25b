import { heaviestEntry } from '../../skinning/heaviest-entry.ts';
import { applyRows, axes, ghostsOf, motionOf, pointOf } from './entry-motions.ts';
import type { Explain } from './explanation.ts';

/** Rigid parts: the joint of the largest weight takes the point with it, whatever the others do. */
export const explainRigid: Explain = (evaluation, point) => {
  const rest = pointOf(evaluation.rest.positions, point);
  const entry = heaviestEntry(evaluation.skin, point);
  const place = applyRows(motionOf(evaluation, entry), rest);
  return {
    ...{ rest, place, marks: [] },
    ghosts: ghostsOf(evaluation, point),
    steps: [
      {
        title: 'T·B⁻¹·p of the joint with the largest weight: the vertex',
        columns: axes,
        rows: [{ of: entry, values: place }],
        total: place,
      },
    ],
  };
};
