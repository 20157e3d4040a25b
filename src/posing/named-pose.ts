import type { Pose } from '../core/pose.ts';
import { jointRange } from '../core/pose.ts';
import { DofKind, type Skeleton } from '../core/skeleton.ts';

/** The values of a joint under its name, so that a joint of another skeleton can take them. */
export interface NamedJoint {
  readonly name: string;
  /**
   * What the values are, in stored order: x, y, z are slides along these axes, X, Y, Z hinges about
   * them, and Q is a ball with four values. `s` and `h` are slides and hinges along other axes.
   */
  readonly dofs: string;
  /** Model units, radians, quaternions xyzw. */
  readonly values: readonly number[];
}

/** The weight of a morph under its name. */
export interface NamedMorph {
  readonly name: string;
  readonly weight: number;
}

/** A pose, or a part of one, that belongs to no skeleton. It says nothing about what it omits. */
export interface NamedPose {
  /**
   * The height of the character that it was taken from, in model units, by which slides are scaled
   * for a character of another size; 0 if it is not known.
   */
  readonly height: number;
  readonly joints: readonly NamedJoint[];
  readonly morphs: readonly NamedMorph[];
}

/** What a pose is taken from, and fitted to. */
export interface PosedThing {
  readonly skeleton: Skeleton;
  readonly morphs: readonly { readonly name: string }[];
  readonly bounds: { readonly min: ArrayLike<number>; readonly max: ArrayLike<number> };
}

/** The letters of a joint's degrees of freedom; see `NamedJoint.dofs`. */
export function dofLetters({ dofStart, dofKind, dofAxis }: Skeleton, joint: number): string {
  let letters = '';
  for (let dof = dofStart[joint]!; dof < dofStart[joint + 1]!; dof++) {
    const kind = dofKind[dof];
    const axis = dofAxis.subarray(dof * 3, dof * 3 + 3).indexOf(1);
    if (kind === DofKind.ball) letters += 'Q';
    else if (kind === DofKind.slide) letters += 'xyz'[axis] ?? 's';
    else letters += 'XYZ'[axis] ?? 'h';
  }
  return letters;
}

/**
 * Returns the pose of some joints by name, without those that nothing can move, and the weights of
 * all morphs if it is of all joints.
 */
export function namePose(
  { skeleton, morphs, bounds }: PosedThing,
  { q, morphWeights }: Pose,
  joints: readonly number[],
): NamedPose {
  const isWhole = joints.length === skeleton.jointCount;
  return {
    height: heightOf(bounds),
    joints: joints.flatMap((joint) => {
      const values = [...q.subarray(...jointRange(skeleton, joint))];
      const name = skeleton.names[joint]!;
      return values.length > 0 ? [{ name, dofs: dofLetters(skeleton, joint), values }] : [];
    }),
    morphs: isWhole
      ? morphs.map(({ name }, morph) => ({ name, weight: morphWeights?.[morph] ?? 0 }))
      : [],
  };
}

export function heightOf({ min, max }: PosedThing['bounds']): number {
  const height = max[1]! - min[1]!;
  return Number.isFinite(height) && height > 0 ? height : 0;
}
