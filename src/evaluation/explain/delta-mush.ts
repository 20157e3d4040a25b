import type { Vector3 } from '../../posing/ik/problem.ts';
import { endsOf, mushSurface, turnPlace } from '../../skinning/delta-mush.ts';
import { linearBlend } from '../../skinning/linear-blend.ts';
import { plainUse } from '../../skinning/method.ts';
import { surfaceOf } from '../../skinning/mushed-surface.ts';
import type { Evaluation } from '../evaluation.ts';
import { axes, ghostsOf, pointOf, sumOfVectors } from './entry-motions.ts';
import type { Explain } from './explanation.ts';

/** Delta mush: the smoothed skin, and the detail that smoothing takes away at rest, turned. */
export const explainDeltaMush: Explain = (evaluation, point) => {
  const { skin, use } = evaluation;
  const linear = linearPositions(evaluation);
  const surface = surfaceOf(evaluation.state.character.mesh, skin);
  const mushed = mushSurface(surface, linear, use.settings);
  const at = surface.placeOf[point]!;
  const turn = new Float64Array(9);
  turnPlace(mushed, at, turn);
  const ends = endsOf(mushed, at);
  const [from, to] = [pointOf(ends.from, at), pointOf(ends.to, at)];
  const p = pointOf(evaluation.rest.positions, point);
  const detail: Vector3 = [p[0] - from[0], p[1] - from[1], p[2] - from[2]];
  const offset = turnedBy(turn, detail);
  const place = sumOfVectors([to, offset]);
  const blended = pointOf(linear, point);
  return {
    ...{ rest: p, place },
    ghosts: ghostsOf(evaluation, point),
    marks: [
      { label: 'linear blend', place: blended },
      { label: 'smoothed', place: to },
    ],
    steps: [
      {
        title: 'At rest: the detail that smoothing takes away',
        columns: axes,
        rows: [
          { of: 'vertex p', values: p },
          { of: '− smoothed S(X)', values: [-from[0], -from[1], -from[2]] },
        ],
        total: detail,
      },
      {
        title: 'Posed by linear blend, before the skin is smoothed',
        columns: axes,
        rows: [{ of: 'linear blend X′', values: blended }],
        total: null,
      },
      {
        title: 'Smoothed, and the turned detail: the vertex',
        columns: axes,
        rows: [
          { of: 'smoothed S(X′)', values: to },
          { of: 'offset R·(p − S(X))', values: offset },
        ],
        total: place,
      },
    ],
  };
};

/** (vertexCount × 3) what linear blend makes of the mesh without its rest layers. */
function linearPositions({ state, skin, palette }: Evaluation): Float32Array {
  const { mesh } = state.character;
  const positions = new Float32Array(mesh.vertexCount * 3);
  linearBlend.deform(mesh, skin, palette, { positions, normals: null }, plainUse);
  return positions;
}

function turnedBy(rows: ArrayLike<number>, [x, y, z]: Vector3): Vector3 {
  const at = (i: number): number => rows[i]! * x + rows[i + 1]! * y + rows[i + 2]! * z;
  return [at(0), at(3), at(6)];
}
