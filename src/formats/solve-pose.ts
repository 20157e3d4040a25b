import { mat4 } from 'gl-matrix';
import { type EulerProduct, extractEuler } from '../core/euler.ts';
import { jointMatrices } from '../core/forward-kinematics.ts';
import { axisDofs } from '../core/pose.ts';
import { DofKind, noParent, type Skeleton } from '../core/skeleton.ts';
import { firstRoot } from '../core/subtree.ts';
import { noJoint, type Skin } from '../core/skin.ts';

/** The skeleton for which angles are solved. */
export interface Target {
  /** The order of its hinges; of a ball, whose quaternion is made from them, any. */
  readonly product: EulerProduct;
  readonly turnsByBall: boolean;
  /** Whether joints keep their own frames, or are without rotation where the mesh is bound. */
  readonly frames: 'joint' | 'bind';
  /** Whether a new root at the origin is added above the others. */
  readonly insertRoot: boolean;
  /** (jointCount × 3) positions of the joints at bind time. */
  readonly bound: Float64Array;
}

export interface SolvedPose {
  /** (jointCount × 3) x, y, z in the order of the target's product. */
  readonly angles: Float64Array;
  /**
   * The displacement of the first root from its bind position or, with its own frames, from its
   * offset.
   */
  readonly root: readonly [number, number, number];
}

/** Solves for the angles that rotate the target's joints as q rotates the skeleton's. */
export function solvePose(
  skeleton: Skeleton,
  skin: Skin,
  q: Float64Array,
  { product, frames, bound }: Target,
): SolvedPose {
  const world = jointMatrices(skeleton, q);
  const turned = frames === 'joint' ? world : turnsSinceBind(skeleton, skin, world);
  const angles = new Float64Array(skeleton.jointCount * 3);
  const local = new Float64Array(16);
  for (let joint = 0; joint < skeleton.jointCount; joint++) {
    const parent = skeleton.parents[joint]!;
    const own = turned.subarray(joint * 16, joint * 16 + 16);
    if (parent === noParent) local.set(own);
    else {
      mat4.invert(local, turned.subarray(parent * 16, parent * 16 + 16));
      mat4.multiply(local, local, own);
    }
    angles.set(extractEuler(local, product, hingeAngles(skeleton, joint, q)), joint * 3);
  }
  const root = firstRoot(skeleton);
  const from = frames === 'joint' ? skeleton.restOffsets : bound;
  const moved = [0, 1, 2].map((axis) => world[root * 16 + 12 + axis]! - from[root * 3 + axis]!);
  return { angles, root: [moved[0]!, moved[1]!, moved[2]!] };
}

/** (jointCount × 16) W · B⁻¹: the rotation of each joint since the mesh was bound. */
function turnsSinceBind(skeleton: Skeleton, skin: Skin, world: Float64Array): Float64Array {
  const out = new Float64Array(world.length);
  const rest = jointMatrices(skeleton, skeleton.qRest);
  const inverse = new Float64Array(16);
  for (let joint = 0; joint < skeleton.jointCount; joint++) {
    const entry = skin.paletteJoint.indexOf(joint);
    const range = [joint * 16, joint * 16 + 16] as const;
    if (entry === -1 || skin.paletteJoint.includes(noJoint)) {
      mat4.invert(inverse, rest.subarray(...range));
    } else inverse.set(skin.jointFromBind.subarray(entry * 16, entry * 16 + 16));
    mat4.multiply(out.subarray(...range), world.subarray(...range), inverse);
  }
  return out;
}

/** x, y, z of a joint's hinges; the new angles should be near to them. */
function hingeAngles(skeleton: Skeleton, joint: number, q: Float64Array): number[] {
  const angles = [0, 0, 0];
  for (const { kind, axis, index } of axisDofs(skeleton, joint)) {
    if (kind === DofKind.hinge) angles[axis] = q[index]!;
  }
  return angles;
}
