import { type Matrix, multiply, type Vector } from './matrix.ts';

export type Influence = readonly [joint: number, weight: number];

/** A vertex with its weights; joints are given by their index in the file. */
export interface Vertex {
  readonly position: Vector;
  readonly normal: Vector;
  readonly influences: readonly Influence[];
  /** Its center of rotation in the bind pose, for the method that has one; null for none. */
  readonly center?: Vector | null;
}

/** T of every joint, and the inverse of its B. */
export interface Transforms {
  readonly characterFromJoint: readonly Matrix[];
  readonly jointFromBind: readonly Matrix[];
  /** The joint that vertices without weights follow. */
  readonly firstRoot: number;
}

/** The weights that count; a vertex without any follows the first root. */
export function influencesOf(
  { influences }: Vertex,
  { firstRoot }: Transforms,
): readonly Influence[] {
  const used = influences.filter(([, weight]) => weight !== 0);
  return used.length > 0 ? used : [[firstRoot, 1]];
}

/** Each is computed once, although many vertices ask for it. */
const skinningMatrices = new WeakMap<Transforms, Map<number, Matrix>>();

/** M = T · B⁻¹ of a joint: from the bind pose to the pose, in the character's space. */
export function skinningMatrix(joint: number, transforms: Transforms): Matrix {
  let known = skinningMatrices.get(transforms);
  if (!known) skinningMatrices.set(transforms, (known = new Map<number, Matrix>()));
  let matrix = known.get(joint);
  if (!matrix) {
    matrix = multiply(transforms.characterFromJoint[joint]!, transforms.jointFromBind[joint]!);
    known.set(joint, matrix);
  }
  return matrix;
}
