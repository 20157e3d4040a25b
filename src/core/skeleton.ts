/** Kinds of degree of freedom: a `slide` has 1 value, a `hinge` 1 (radians), a `ball` 4 (xyzw). */
export const DofKind = { slide: 0, hinge: 1, ball: 2 } as const;
export type DofKind = (typeof DofKind)[keyof typeof DofKind];

export const dofSize: Readonly<Record<DofKind, number>> = {
  [DofKind.slide]: 1,
  [DofKind.hinge]: 1,
  [DofKind.ball]: 4,
};

/**
 * A tree (or forest) of joints as a struct of arrays, after MuJoCo's model: it never changes, and
 * all that a pose changes stands in one vector `q`. The local matrix of joint j is
 * `T(restOffset) · R(restRotation) · D1 · … · Dk`, its own degrees of freedom left to right.
 *
 * Joints stand depth first, so `parents[j] < j`, and a subtree is a contiguous range.
 */
export interface Skeleton {
  readonly jointCount: number;
  /** Unique, for display and POSE.json. */
  readonly names: readonly string[];
  /** As read; empty where the format has none. For writers. */
  readonly fileNames: readonly string[];
  /** (jointCount) index in the file, since joints are sorted depth first. */
  readonly sourceIndex: Uint16Array;
  /** (jointCount) the inverse of `sourceIndex`. */
  readonly jointOfSource: Uint16Array;
  /** (jointCount) -1 is a root; several roots are allowed. */
  readonly parents: Int16Array;
  /** (jointCount) 0 for a root. */
  readonly depths: Uint16Array;
  /** (jointCount × 3) in the parent's frame, model units. */
  readonly restOffsets: Float64Array;
  /** (jointCount × 4) unit quaternions xyzw. */
  readonly restRotations: Float64Array;
  /** (jointCount + 1) where each joint's degrees of freedom start. */
  readonly dofStart: Uint16Array;
  /** (dofCount) */
  readonly dofKind: Uint8Array;
  /** (dofCount × 3) unit, joint frame; unused by balls. */
  readonly dofAxis: Float64Array;
  /** (dofCount) where its first value stands in q. */
  readonly dofQ: Uint32Array;
  /** (qCount) the file's pose, within the limits. */
  readonly qRest: Float64Array;
  /** (qCount) radians or model units; -Infinity is unlimited. */
  readonly qMin: Float64Array;
  /** (qCount) */
  readonly qMax: Float64Array;
  /** (jointCount × 6) min x y z, max x y z of the box that stands for a joint, joint frame. */
  readonly displayBoxes: Float32Array | null;
}

export const noParent = -1;

/** The last joint of j's subtree, plus one: joints j … end - 1 are j and all below it. */
export function subtreeEnd(skeleton: Skeleton, joint: number): number {
  const { depths, jointCount } = skeleton;
  let end = joint + 1;
  while (end < jointCount && depths[end]! > depths[joint]!) end++;
  return end;
}

/** The root that POSE.json's `root` moves: the one of lowest index in the file; -1 without joints. */
export function firstRoot(skeleton: Skeleton): number {
  for (const joint of skeleton.jointOfSource)
    if (skeleton.parents[joint] === noParent) return joint;
  return -1;
}
