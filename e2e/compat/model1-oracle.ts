import { characterFromJoints, type Joint } from '../../tests/reference/kinematics.ts';
import { inverse } from '../../tests/reference/matrix.ts';
import { type Influence } from '../../tests/reference/skinned-vertex.ts';
import { methodOracles } from '../../tests/reference/skinning.ts';
import type { PoseJson } from '../../src/formats/pose-json.ts';
import { model1Files } from '../support/shared.ts';

const axes = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];
const hinges = axes.map((axis) => ({ kind: 'hinge', axis }) as const);

/**
 * Poses Model1 with the float64 reference and returns (vertices × 3). The pose names the joints
 * `#0`, `#1`, ….
 */
export function posedModel1({ joints: angles = {} }: PoseJson): Float64Array {
  const [skel, obj, attach] = model1Files().map(({ content }) => rows(String(content)));
  const joints = skel!.map(([x, y, z, parent]): Joint => {
    const offset = [Number(x), Number(y), Number(z)];
    return { parent: Number(parent), offset, rotation: [0, 0, 0, 1], freedoms: hinges };
  });
  const atRest = joints.map(() => hinges.map(() => [0]));
  const posed = joints.map((_, index) => (angles[`#${index}`] ?? [0, 0, 0]).map((x) => [x]));
  const transforms = {
    characterFromJoint: characterFromJoints(joints, posed),
    jointFromBind: characterFromJoints(joints, atRest).map(inverse),
    firstRoot: 0,
  };
  const points = obj!.filter(([keyword]) => keyword === 'v').map((row) => row.slice(1).map(Number));
  const vertices = points.map((position, index) => {
    // The root has no column in the file.
    const row = attach![index]!.map((weight, i): Influence => [i + 1, Number(weight)]);
    const influences = row.filter(([, weight]) => weight !== 0);
    return { position, normal: [0, 1, 0], influences };
  });
  const oracle = methodOracles['linear-blend']!;
  return Float64Array.from(vertices.flatMap((vertex) => [...oracle.position(vertex, transforms)]));
}

function rows(text: string): string[][] {
  return text
    .split('\n')
    .map((line) => line.trim())
    .filter((line) => line !== '')
    .map((line) => line.split(/\s+/));
}
