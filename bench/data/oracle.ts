import { characterFromJoints, type Joint, type Values } from '../../tests/reference/kinematics.ts';
import { inverse } from '../../tests/reference/matrix.ts';
import { type Transforms, type Vertex } from '../../tests/reference/skinned-vertex.ts';
import { methodOracles } from '../../tests/reference/skinning.ts';
import type { MethodId } from '../../src/skinning/method.ts';
import type { Mesh } from '../../src/core/mesh.ts';
import { expectRight } from '../harness/group.ts';
import type { Cylinder } from './cylinder.ts';

/** The largest error in the body's units, which is one tall: float32 sums of 17 terms reach 1e-6. */
const tolerance = 4e-6;
/** Every so many vertices are checked. */
const stride = 97;

const axes = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/** The transforms of a chain of joints in a pose, by the float64 oracle of the tests. */
export function transformsOf(body: Cylinder, angles: Float64Array): Transforms {
  const joints = Array.from({ length: body.jointCount }, (_, index): Joint => ({
    parent: index - 1,
    offset: [0, index === 0 ? 0 : body.jointSpacing, 0],
    rotation: [0, 0, 0, 1],
    freedoms: axes.map((axis) => ({ kind: 'hinge', axis })),
  }));
  const values: Values = joints.map((_, index) =>
    [0, 1, 2].map((axis) => [angles[index * 3 + axis]!]),
  );
  const atRest: Values = joints.map(() => [[0], [0], [0]]);
  return {
    characterFromJoint: characterFromJoints(joints, values),
    jointFromBind: characterFromJoints(joints, atRest).map(inverse),
    firstRoot: 0,
  };
}

export interface Answer {
  readonly id: string;
  readonly positions: ArrayLike<number>;
  readonly normals?: ArrayLike<number>;
}

/** Checks posed vertices against the oracle. */
export function checkSkinned(
  { id, positions, normals }: Answer,
  body: Cylinder,
  mesh: Mesh,
  transforms: Transforms,
  method: MethodId = 'linear-blend',
): void {
  const oracle = methodOracles[method]!;
  for (let v = 0; v < body.vertexCount; v += stride) {
    const vertex = vertexOf(v, body, mesh);
    const wanted = oracle.position(vertex, transforms);
    const wantedNormal = normals ? oracle.normal(vertex, transforms) : [];
    for (let axis = 0; axis < 3; axis++) {
      near(positions[v * 3 + axis]!, wanted[axis]!, tolerance, `${id}, vertex ${v}`);
      if (normals) near(normals[v * 3 + axis]!, wantedNormal[axis]!, 1e-5, `${id}, normal ${v}`);
    }
  }
}

function near(found: number, wanted: number, within: number, what: string): void {
  expectRight(Math.abs(found - wanted) <= within, `${what} is ${found}, not ${wanted}`);
}

function vertexOf(vertex: number, body: Cylinder, mesh: Mesh): Vertex {
  const [from, to] = [body.start[vertex]!, body.start[vertex + 1]!];
  const triple = (values: Float32Array): number[] => [
    ...values.subarray(vertex * 3, vertex * 3 + 3),
  ];
  return {
    position: triple(body.positions),
    normal: triple(mesh.normals),
    influences: Array.from(body.joints.subarray(from, to), (joint, i) => [
      joint,
      body.weights[from + i]!,
    ]),
  };
}
