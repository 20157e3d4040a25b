import { mat3, quat } from 'gl-matrix';
import { extractEuler } from '../../core/euler.ts';
import { jointRange } from '../../core/pose.ts';
import { DofKind, dofSize, type Skeleton } from '../../core/skeleton.ts';
import type { JointNature } from '../ik/problem.ts';
import { swingTwist } from '../ik/swing-twist.ts';

const fullTurn = 2 * Math.PI;

/** Sideways ranges end below a right angle, where the three angles are singular. */
const widestSide = (80 * Math.PI) / 180;

/** How a joint is rotated by its own degrees of freedom: one ball, or three hinges. */
interface OwnRotation {
  /** The indices in q: of the ball's four values, or of the three angles. */
  readonly indices: readonly number[];
  /** Column-major, 3 × 3: the hinges' axes in the joint's frame; null for a ball. */
  readonly axes: Float64Array | null;
  /** 1 if the axes, in their order, are right-handed, otherwise -1. */
  readonly handedness: number;
}

/** A joint that rotates by the angles of its nature in place of its own degrees of freedom. */
interface NaturalJoint {
  readonly nature: JointNature;
  readonly own: OwnRotation;
  /** The index of the first of its three angles: bend, side and twist. */
  readonly index: number;
}

/**
 * A skeleton whose joints turn about the axes of their natures: each one that can turn freely has
 * three hinges, for bending, bending sideways and twisting. In these coordinates a soft range is a
 * box, as a file's limits are, so that every method can keep to it. Joints that their file limits,
 * and those that may swing to any direction, keep their own degrees of freedom.
 */
export interface NaturalSkeleton {
  /** The character's. */
  readonly own: Skeleton;
  readonly skeleton: Skeleton;
  readonly natures: readonly JointNature[];
  readonly joints: readonly NaturalJoint[];
  /** (qCount of `skeleton`) the index of the same value in the character's q, or -1. */
  readonly sources: Int32Array;
}

/** Returns the skeleton, with the soft ranges as its limits. */
export function naturalSkeleton(own: Skeleton, natures: readonly JointNature[]): NaturalSkeleton {
  const natureOf = new Map(natures.map((nature) => [nature.joint, nature]));
  const joints: NaturalJoint[] = [];
  const dofs: { kind: DofKind; axis: readonly number[]; index: number }[] = [];
  const dofStart = new Uint16Array(own.jointCount + 1);
  const values: { source: number; rest: number; min: number; max: number }[] = [];
  for (let joint = 0; joint < own.jointCount; joint++) {
    dofStart[joint] = dofs.length;
    const nature = natureOf.get(joint);
    const rotation = nature && isWithinSide(nature) ? freeRotation(own, joint) : null;
    let isPlaced = false;
    for (let dof = own.dofStart[joint]!; dof < own.dofStart[joint + 1]!; dof++) {
      const kind = own.dofKind[dof] as DofKind;
      if (nature && rotation && kind !== DofKind.slide) {
        if (!isPlaced) addHinges(nature, rotation);
        isPlaced = true;
      } else addOwn(dof, kind);
    }
  }
  dofStart[own.jointCount] = dofs.length;
  const skeleton: Skeleton = {
    ...own,
    dofStart,
    dofKind: Uint8Array.from(dofs, ({ kind }) => kind),
    dofAxis: Float64Array.from(dofs.flatMap(({ axis }) => axis)),
    dofQ: Uint32Array.from(dofs, ({ index }) => index),
    qRest: Float64Array.from(values, ({ rest }) => rest),
    qMin: Float64Array.from(values, ({ min }) => min),
    qMax: Float64Array.from(values, ({ max }) => max),
  };
  return {
    own,
    skeleton,
    natures,
    joints,
    sources: Int32Array.from(values, ({ source }) => source),
  };

  function addHinges(nature: JointNature, rotation: OwnRotation): void {
    const axes = new Float64Array(9);
    mat3.fromQuat(axes, [...nature.jointFromNature]);
    joints.push({ nature, own: rotation, index: values.length });
    [nature.bend, nature.side, nature.twist].forEach(([min, max], column) => {
      const axis = [...axes.subarray(column * 3, column * 3 + 3)];
      dofs.push({ kind: DofKind.hinge, axis, index: values.length });
      values.push({ source: -1, rest: 0, min, max });
    });
  }

  function addOwn(dof: number, kind: DofKind): void {
    const axis = [...own.dofAxis.subarray(dof * 3, dof * 3 + 3)];
    dofs.push({ kind, axis, index: values.length });
    for (let i = 0; i < dofSize[kind]; i++) {
      const source = own.dofQ[dof]! + i;
      const [rest, min, max] = [own.qRest[source]!, own.qMin[source]!, own.qMax[source]!];
      values.push({ source, rest, min, max });
    }
  }
}

/** Whether a nature's own angles are the ones to turn by. */
function isWithinSide({ side: [low, high] }: JointNature): boolean {
  return low >= -widestSide && high <= widestSide;
}

/** Returns the values of a pose of the character in natural coordinates. */
export function toNatural(natural: NaturalSkeleton, q: Float64Array): Float64Array {
  const values = Float64Array.from(natural.sources, (source) => (source < 0 ? 0 : q[source]!));
  for (const { nature, index } of natural.joints) {
    values.set(naturalAngles(nature, jointRotation(natural.own, nature.joint, q)), index);
  }
  return values;
}

/**
 * Returns a pose of the character in which natural coordinates have these values. A joint whose angles
 * are those of `start` keeps its bits; of equal rotations, those nearest to `near` are taken.
 *
 * @param values in natural coordinates
 * @param start `near` in natural coordinates
 * @param near (qCount) a pose of the character
 */
export function fromNatural(
  natural: NaturalSkeleton,
  values: Float64Array,
  start: Float64Array,
  near: Float64Array,
): Float64Array {
  const q = near.slice();
  natural.sources.forEach((source, i) => {
    if (source >= 0) q[source] = values[i]!;
  });
  for (const { nature, own, index } of natural.joints) {
    if ([0, 1, 2].every((i) => Object.is(values[index + i], start[index + i]))) continue;
    writeOwn(own, rotationOf(nature, values.subarray(index, index + 3)), q);
  }
  return q;
}

/** The angles of bend, side and twist about the nature's axes, one after another. */
function naturalAngles(nature: JointNature, rotation: quat): [number, number, number] {
  const inNature = mat3.fromQuat(new Float64Array(9), inFrame(nature, rotation));
  return extractEuler(elements(inNature), 'xyz', [0, 0, 0]);
}

/**
 * Returns a joint's bend, side and twist in a pose of the character, in radians, as its soft ranges
 * count them: by the hinges of natural coordinates, or by swing and twist where it keeps its own
 * degrees of freedom.
 */
export function presentAngles(
  skeleton: Skeleton,
  nature: JointNature,
  q: Float64Array,
): [number, number, number] {
  const hasHinges = isWithinSide(nature) && freeRotation(skeleton, nature.joint) !== null;
  if (!hasHinges) return swingAngles(skeleton, nature, q);
  return naturalAngles(nature, jointRotation(skeleton, nature.joint, q));
}

/**
 * A joint's swing, as a rotation vector about the axes of bending, and its twist, in a pose of the
 * character: bend, side and twist in radians.
 */
export function swingAngles(
  skeleton: Skeleton,
  nature: JointNature,
  q: Float64Array,
): [number, number, number] {
  const angles = new Float64Array(3);
  const rotation = inFrame(nature, jointRotation(skeleton, nature.joint, q));
  swingTwist(Float64Array.from(rotation), angles);
  return [angles[0]!, angles[1]!, angles[2]!];
}

/** A rotation of the joint in the axes of its nature. */
function inFrame({ jointFromNature }: JointNature, rotation: quat): quat {
  const inNature = quat.conjugate(new Float64Array(4), [...jointFromNature]);
  quat.multiply(inNature, inNature, rotation);
  return quat.multiply(inNature, inNature, [...jointFromNature]);
}

/** The product of a joint's rotating degrees of freedom. */
function jointRotation(
  { dofStart, dofKind, dofQ, dofAxis }: Skeleton,
  joint: number,
  q: Float64Array,
): quat {
  const rotation = Float64Array.of(0, 0, 0, 1);
  for (let dof = dofStart[joint]!; dof < dofStart[joint + 1]!; dof++) {
    const at = dofQ[dof]!;
    if (dofKind[dof] === DofKind.ball) quat.multiply(rotation, rotation, q.subarray(at, at + 4));
    if (dofKind[dof] !== DofKind.hinge) continue;
    const axis = dofAxis.subarray(dof * 3, dof * 3 + 3);
    quat.multiply(rotation, rotation, quat.setAxisAngle(new Float64Array(4), axis, q[at]!));
  }
  return rotation;
}

/** The rotation from the joint's rest, for angles of bend, side and twist. */
function rotationOf(nature: JointNature, angles: ArrayLike<number>): quat {
  const rotation = quat.copy(new Float64Array(4), [...nature.jointFromNature]);
  const back = quat.conjugate(new Float64Array(4), rotation);
  quat.rotateX(rotation, rotation, angles[0]!);
  quat.rotateY(rotation, rotation, angles[1]!);
  quat.rotateZ(rotation, rotation, angles[2]!);
  quat.multiply(rotation, rotation, back);
  return quat.normalize(rotation, rotation);
}

/** The joint's rotating degrees of freedom if they reach any rotation; otherwise null. */
function freeRotation(skeleton: Skeleton, joint: number): OwnRotation | null {
  const { dofStart, dofKind, dofQ, dofAxis, qMin, qMax } = skeleton;
  const turning: number[] = [];
  for (let dof = dofStart[joint]!; dof < dofStart[joint + 1]!; dof++) {
    if (dofKind[dof] !== DofKind.slide) turning.push(dof);
    else if (turning.length > 0 && dof < dofStart[joint + 1]! - 1) return null;
  }
  const [from, to] = jointRange(skeleton, joint);
  for (let i = from; i < to; i++) {
    const isSlide = turning.every((dof) => i < dofQ[dof]! || i > dofQ[dof]! + 3);
    if (!isSlide && dofKind[turning[0]!] === DofKind.hinge && qMax[i]! - qMin[i]! < fullTurn) {
      return null;
    }
  }
  const [first] = turning;
  if (first === undefined) return null;
  if (turning.length === 1 && dofKind[first] === DofKind.ball) {
    return { indices: [0, 1, 2, 3].map((i) => dofQ[first]! + i), axes: null, handedness: 1 };
  }
  if (turning.length !== 3 || turning.some((dof) => dofKind[dof] !== DofKind.hinge)) return null;
  const axes = new Float64Array(9);
  turning.forEach((dof, i) => {
    axes.set(dofAxis.subarray(dof * 3, dof * 3 + 3), i * 3);
  });
  const determinant = mat3.determinant(axes);
  if (Math.abs(Math.abs(determinant) - 1) > 1e-9) return null;
  return { indices: turning.map((dof) => dofQ[dof]!), axes, handedness: Math.sign(determinant) };
}

/**
 * Writes a rotation as the joint's own values. In the frame of the hinges' axes B, a product of
 * three hinges is Rx · Ry · Rz, with reversed angles where B is a reflection (hinge-triple.ts).
 */
function writeOwn({ indices, axes, handedness }: OwnRotation, rotation: quat, q: Float64Array) {
  if (!axes) {
    const [x, y, z, w] = indices.map((index) => q[index]!);
    const sign =
      x! * rotation[0] + y! * rotation[1] + z! * rotation[2] + w! * rotation[3] < 0 ? -1 : 1;
    indices.forEach((index, i) => (q[index] = sign * rotation[i]!));
    return;
  }
  const inAxes = mat3.fromQuat(new Float64Array(9), rotation);
  mat3.multiply(inAxes, inAxes, axes);
  mat3.multiply(inAxes, mat3.transpose(new Float64Array(9), axes), inAxes);
  const near = indices.map((index) => handedness * q[index]!);
  extractEuler(elements(inAxes), 'xyz', near).forEach((angle, i) => {
    q[indices[i]!] = handedness * angle;
  });
}

/** The elements of a 3 × 3 matrix where a 4 × 4 one has them. */
function elements(m: mat3): number[] {
  return [m[0], m[1], m[2], 0, m[3], m[4], m[5], 0, m[6], m[7], m[8]];
}
