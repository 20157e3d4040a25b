/** Kinds of degree of freedom: a `slide` has 1 value, a `hinge` 1 (radians), a `ball` 4 (xyzw). */
export const DofKind = { slide: 0, hinge: 1, ball: 2 } as const;
export type DofKind = (typeof DofKind)[keyof typeof DofKind];

export const dofSize: Readonly<Record<DofKind, number>> = {
  [DofKind.slide]: 1,
  [DofKind.hinge]: 1,
  [DofKind.ball]: 4,
};

/**
 * A tree (or forest) of joints as a struct of arrays, following MuJoCo's model. It never changes;
 * all values that a pose changes are in one vector `q`. The local matrix of joint j is
 * `T(restOffset) · R(restRotation) · D1 · … · Dk`, with its own degrees of freedom from left to
 * right.
 *
 * Joints are sorted depth first, so `parents[j] < j`, and a subtree is a contiguous range.
 */
export interface Skeleton {
  readonly jointCount: number;
  /** Unique, for display and POSE.json. */
  readonly names: readonly string[];
  /** (jointCount) the names in English, each empty if the file has none beside the other. */
  readonly englishNames?: readonly string[];
  /** Names as read, for writers; empty if the format has none. */
  readonly fileNames: readonly string[];
  /** (jointCount) index of each joint in the file. */
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
  /** (dofCount) index of its first value in q. */
  readonly dofQ: Uint32Array;
  /** (qCount) the file's pose, within the limits. */
  readonly qRest: Float64Array;
  /** (qCount) in radians or model units; -Infinity means unlimited. */
  readonly qMin: Float64Array;
  /** (qCount) */
  readonly qMax: Float64Array;
  /**
   * (jointCount × 6) min x y z, max x y z of the box that is drawn for a joint, in the joint's
   * frame.
   */
  readonly displayBoxes: Float32Array | null;
}

export const noParent = -1;
