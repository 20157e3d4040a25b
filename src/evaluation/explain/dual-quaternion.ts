import { writeRotationQuaternion } from '../../core/rotation-quaternion.ts';
import type { Quaternion, Vector3 } from '../../posing/ik/problem.ts';
import { rotationAt } from '../../skinning/blend-motions.ts';
import { dualQuaternion } from '../../skinning/dual-quaternion.ts';
import { settingOf } from '../../skinning/method.ts';
import { writeRigidMotion } from '../../skinning/entry-motion.ts';
import type { Evaluation } from '../evaluation.ts';
import { axes, ghostsOf, scaled, sumOfVectors } from './entry-motions.ts';
import type { ExplainedRow, Explain } from './explanation.ts';
import { explainLinearBlend } from './linear-blend.ts';
import { stretchedPlace } from './mean-stretch.ts';
import {
  axisAndAngle,
  scaledQuaternion,
  shortest,
  signedInfluences,
  sumStep,
  sumOfQuaternions,
  turned,
} from './quaternions.ts';

/** Dual quaternions: their signed weighted sum, the motion it gives, and the point so moved. */
export const explainDualQuaternion: Explain = (evaluation, point) => {
  const linear = explainLinearBlend(evaluation, point);
  const share = settingOf(evaluation.use.settings, dualQuaternion.parameters![0]!);
  const signed = signedInfluences(evaluation, evaluation.skin, point, rotationAt);
  const motions = signed.map(({ entry }) => dualQuaternionOf(evaluation, entry));
  const weighted = (quaternion: Quaternion, i: number): Quaternion =>
    scaledQuaternion(quaternion, signed[i]!.weight);
  const rotations = motions.map((motion, i) => weighted(motion.rotation, i));
  const duals = motions.map((motion, i) => weighted(motion.dual, i));
  const [rotation, dual] = [sumOfQuaternions(rotations), sumOfQuaternions(duals)];
  const length = Math.hypot(...rotation);
  const sums = [
    sumStep('s·w·q, the rotations', signed, rotations),
    sumStep('s·w·q′, their dual parts', signed, duals),
  ];
  if (length < shortest || share === 0) {
    const note =
      share === 0
        ? 'The blend is 0, so this is linear blend.'
        : 'The sum has no direction, so linear blend moves this vertex.';
    return { ...linear, steps: [...sums, ...linear.steps], note };
  }
  const turn = scaledQuaternion(rotation, 1 / length);
  const shift = translationOf(turn, scaledQuaternion(dual, 1 / length));
  const stretched = stretchedPlace(evaluation.skin, signed, linear.rest);
  const [axis, angle] = axisAndAngle(turn);
  const rows: ExplainedRow[] = [
    { of: 'turned R·p', values: scaled(turned(turn, stretched ?? linear.rest), share) },
    { of: 'moved t', values: scaled(shift, share) },
    ...(share < 1 ? [{ of: 'linear blend', values: scaled(linear.place, 1 - share) }] : []),
  ];
  const place = sumOfVectors(rows.map(({ values }) => values as unknown as Vector3));
  return {
    rest: linear.rest,
    ...{ place, ghosts: ghostsOf(evaluation, point), marks: [] },
    steps: [
      ...sums,
      {
        title: 'Divided by the length of the sum: one rigid motion',
        columns: axes,
        rows: [
          { of: 'length of the sum', values: [length] },
          { of: 'turn, degrees', values: [angle] },
          { of: 'about the axis', values: axis },
          ...(stretched ? [{ of: 'p, stretched first', values: stretched }] : []),
        ],
        total: null,
      },
      {
        title:
          share < 1
            ? 'That motion of p, and linear blend, by the blend'
            : 'That motion of p: the vertex',
        columns: axes,
        rows,
        total: place,
      },
    ],
  };
};

/** The rotation of an entry, and the dual part `½ (t, 0) q`. */
function dualQuaternionOf({ skin, characterFromJoint }: Evaluation, entry: number) {
  const motion = new Float64Array(16);
  const q = new Float64Array(4);
  writeRigidMotion(skin, characterFromJoint, entry, motion);
  writeRotationQuaternion(motion, 0, q, 0);
  const [x, y, z, w] = [q[0]!, q[1]!, q[2]!, q[3]!];
  const [tx, ty, tz] = [motion[12]!, motion[13]!, motion[14]!];
  const rotation: Quaternion = [x, y, z, w];
  const dual: Quaternion = [
    0.5 * (tx * w + ty * z - tz * y),
    0.5 * (ty * w + tz * x - tx * z),
    0.5 * (tz * w + tx * y - ty * x),
    -0.5 * (tx * x + ty * y + tz * z),
  ];
  return { rotation, dual };
}

/** The vector part of `2 q′ q*`. */
function translationOf([x, y, z, w]: Quaternion, [ex, ey, ez, ew]: Quaternion): Vector3 {
  return [
    2 * (w * ex - ew * x + y * ez - z * ey),
    2 * (w * ey - ew * y + z * ex - x * ez),
    2 * (w * ez - ew * z + x * ey - y * ex),
  ];
}
