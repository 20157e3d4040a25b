import { DofKind, type Skeleton } from './skeleton.ts';

/** The values that posing changes; the character itself never changes. */
export interface Pose {
  /** (qCount) radians, model units, quaternions xyzw; see `Skeleton.dofQ`. */
  readonly q: Float64Array;
  /** (morphCount) the weight of each morph; all 0 if absent. */
  readonly morphWeights?: Float64Array;
}

/** The file's pose. */
export function restPose(skeleton: Skeleton): Pose {
  return { q: skeleton.qRest.slice() };
}

/** A degree of freedom as the interface shows it: a joint's slide or hinge along x, y or z. */
export interface AxisDof {
  readonly dof: number;
  readonly kind: typeof DofKind.slide | typeof DofKind.hinge;
  readonly axis: 0 | 1 | 2;
  /** Its index in q. */
  readonly index: number;
}

/** The joint's slides and hinges along the coordinate axes, in stored order. */
export function axisDofs(skeleton: Skeleton, joint: number): AxisDof[] {
  const found: AxisDof[] = [];
  for (let dof = skeleton.dofStart[joint]!; dof < skeleton.dofStart[joint + 1]!; dof++) {
    const kind = skeleton.dofKind[dof]!;
    if (kind === DofKind.ball) continue;
    const axis = [0, 1, 2].find((i) => skeleton.dofAxis[dof * 3 + i] === 1);
    if (axis === undefined) continue;
    found.push({
      dof,
      kind: kind as AxisDof['kind'],
      axis: axis as AxisDof['axis'],
      index: skeleton.dofQ[dof]!,
    });
  }
  return found;
}

/** The joint to which a value of q belongs. */
export function jointOfValue(skeleton: Skeleton, index: number): number {
  let joint = 0;
  while (joint < skeleton.jointCount && jointRange(skeleton, joint)[1] <= index) joint++;
  return joint;
}

/** The range of q that a joint's degrees of freedom occupy, end exclusive. */
export function jointRange(skeleton: Skeleton, joint: number): [number, number] {
  const valueStart = (dof: number): number =>
    dof < skeleton.dofQ.length ? skeleton.dofQ[dof]! : skeleton.qRest.length;
  return [valueStart(skeleton.dofStart[joint]!), valueStart(skeleton.dofStart[joint + 1]!)];
}
