import { writeEntryRotation } from '../../skinning/entry-motion.ts';
import type { Quaternion, Vector3 } from '../../posing/ik/problem.ts';
import { rotationAt } from '../../skinning/centers-of-rotation.ts';
import { positiveSkin } from '../../skinning/positive-skin.ts';
import { hasCenter } from '../../skinning/rest-centers/rest-centers.ts';
import { axes, blendOf, ghostsOf, pointOf, sumOfVectors } from './entry-motions.ts';
import type { Explain } from './explanation.ts';
import { linearBlendBy } from './linear-blend.ts';
import { stretchedPlace } from './mean-stretch.ts';
import {
  axisAndAngle,
  scaledQuaternion,
  shortest,
  signedInfluences,
  sumOfQuaternions,
  sumStep,
  turned,
} from './quaternions.ts';

/** Centers of rotation: linear blend moves the center, and the point turns about it. */
export const explainCentersOfRotation: Explain = (evaluation, point) => {
  const skin = positiveSkin(evaluation.skin);
  const linear = linearBlendBy(evaluation, point, skin);
  const centers = evaluation.use.extra as Float32Array;
  if (!hasCenter(centers, point * 3)) {
    return { ...linear, note: 'Only one joint has a part in it, so it has no center.' };
  }
  const center = pointOf(centers, point);
  const signed = signedInfluences(evaluation, skin, point, rotationAt);
  const rotations = signed.map(({ entry, weight }): Quaternion => {
    const q = new Float64Array(4);
    writeEntryRotation(evaluation.skin, evaluation.characterFromJoint, entry, q, 0);
    return scaledQuaternion([q[0]!, q[1]!, q[2]!, q[3]!], weight);
  });
  const sum = sumOfQuaternions(rotations);
  const length = Math.hypot(...sum);
  const sums = sumStep('s·w·q, the rotations', signed, rotations);
  if (length <= shortest) {
    const note = 'The sum has no direction, so linear blend moves this vertex.';
    return { ...linear, steps: [sums, ...linear.steps], note };
  }
  const turn = scaledQuaternion(sum, 1 / length);
  const arm: Vector3 = [
    linear.rest[0] - center[0],
    linear.rest[1] - center[1],
    linear.rest[2] - center[2],
  ];
  const stretched = stretchedPlace(evaluation.skin, signed, arm);
  const moved = blendOf(ghostsOf(evaluation, point, skin, center));
  const arms = turned(turn, stretched ?? arm);
  const place = sumOfVectors([arms, moved]);
  const [axis, angle] = axisAndAngle(turn);
  return {
    ...linear,
    place,
    marks: [{ label: 'center', place: moved }],
    steps: [
      sums,
      {
        title: 'The center at rest, and the turn about it',
        columns: axes,
        rows: [
          { of: 'center p*', values: center },
          { of: 'arm p − p*', values: arm },
          ...(stretched ? [{ of: 'arm, stretched', values: stretched }] : []),
          { of: 'turn, degrees', values: [angle] },
          { of: 'about the axis', values: axis },
        ],
        total: null,
      },
      {
        title: 'The center by linear blend, and the turned arm: the vertex',
        columns: axes,
        rows: [
          { of: 'center A·p* + t', values: moved },
          { of: 'arm R·(p − p*)', values: arms },
        ],
        total: place,
      },
    ],
  };
};
