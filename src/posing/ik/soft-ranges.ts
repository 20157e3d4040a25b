import { DofKind, type Skeleton } from '../../core/skeleton.ts';
import type { JointNature } from './problem.ts';
import type { SoftTask } from './soft-task.ts';
import { swingTwist, swingTwistRates } from './swing-twist.ts';
import type { TangentSpace } from './tangent-space.ts';

/**
 * The natural ranges of joints: three rows for each, which are how far bend, side and twist are
 * outside their ranges, in radians, and zero inside.
 */
export class SoftRanges implements SoftTask {
  readonly #skeleton: Skeleton;
  readonly #space: TangentSpace;
  readonly #natures: readonly JointNature[];
  /** (natures) the first column of each joint, and the one after its last. */
  readonly #columns: readonly (readonly [number, number])[];
  readonly #rotation = new Float64Array(4);
  readonly #angles = new Float64Array(3);
  readonly #rates = new Float64Array(9);
  readonly #rows: Float64Array;

  constructor(skeleton: Skeleton, space: TangentSpace, natures: readonly JointNature[]) {
    this.#skeleton = skeleton;
    this.#space = space;
    this.#natures = natures.filter(({ joint }) => space.joints.includes(joint));
    this.#columns = this.#natures.map(({ joint }) => [
      space.joints.indexOf(joint),
      space.joints.lastIndexOf(joint) + 1,
    ]);
    this.#rows = new Float64Array(space.columnCount);
  }

  cost(q: Float64Array): number {
    let sum = 0;
    for (const nature of this.#natures) {
      this.#measure(nature, q);
      for (let row = 0; row < 3; row++) {
        const beyond = outside(this.#angles[row]!, rangeOf(nature, row));
        sum += 0.5 * beyond * beyond;
      }
    }
    return sum;
  }

  accumulate(q: Float64Array, weight: number, gradient: Float64Array, matrix: Float64Array): void {
    const { columnCount } = this.#space;
    for (let i = 0; i < this.#natures.length; i++) {
      const nature = this.#natures[i]!;
      const [from, to] = this.#columns[i]!;
      this.#measure(nature, q);
      swingTwistRates(this.#rotation, this.#rates);
      for (let row = 0; row < 3; row++) {
        const beyond = outside(this.#angles[row]!, rangeOf(nature, row));
        if (beyond === 0) continue;
        this.#writeRow(nature, q, from, to, row);
        for (let j = from; j < to; j++) {
          gradient[j] = gradient[j]! + weight * beyond * this.#rows[j]!;
          for (let k = from; k <= j; k++) {
            const at = j * columnCount + k;
            matrix[at] = matrix[at]! + weight * this.#rows[j]! * this.#rows[k]!;
          }
        }
      }
    }
  }

  /** Writes the joint's rotation in the nature's axes, and its bend, side and twist. */
  #measure(nature: JointNature, q: Float64Array): void {
    const { dofStart } = this.#skeleton;
    const rotation = this.#rotation;
    const frame = nature.jointFromNature;
    // N = natureFromJoint · D1 · … · Dk · jointFromNature
    rotation[0] = -frame[0];
    rotation[1] = -frame[1];
    rotation[2] = -frame[2];
    rotation[3] = frame[3];
    const end = dofStart[nature.joint + 1]!;
    for (let dof = dofStart[nature.joint]!; dof < end; dof++) this.#turnBy(dof, q);
    multiply(rotation, frame[0], frame[1], frame[2], frame[3]);
    swingTwist(rotation, this.#angles);
  }

  /** Writes how the columns of a joint change one of its three angles. */
  #writeRow(nature: JointNature, q: Float64Array, from: number, to: number, row: number): void {
    const { kinds, dofs, axes } = this.#space;
    const { dofStart, dofAxis } = this.#skeleton;
    const turned = turnedFrame;
    const [fx, fy, fz, fw] = nature.jointFromNature;
    const kept = keptRotation;
    kept.set(this.#rotation);
    // The columns' axes in the nature's frame: rotated by the degrees of freedom before each.
    this.#rotation.set([-fx, -fy, -fz, fw]);
    let dof = dofStart[nature.joint]!;
    for (let column = from; column < to; column++) {
      for (; dof < dofs[column]!; dof++) this.#turnBy(dof, q);
      if (kinds[column] === DofKind.slide) {
        this.#rows[column] = 0;
        continue;
      }
      const own = dof * 3;
      const isBall = kinds[column] === DofKind.ball;
      for (let k = 0; k < 3; k++)
        turned[k] = isBall ? (k === axes[column] ? 1 : 0) : dofAxis[own + k]!;
      rotateVector(this.#rotation, turned);
      this.#rows[column] =
        this.#rates[row * 3]! * turned[0]! +
        this.#rates[row * 3 + 1]! * turned[1]! +
        this.#rates[row * 3 + 2]! * turned[2]!;
    }
    this.#rotation.set(kept);
  }

  #turnBy(dof: number, q: Float64Array): void {
    const { dofKind, dofQ, dofAxis } = this.#skeleton;
    const at = dofQ[dof]!;
    if (dofKind[dof] === DofKind.ball)
      multiply(this.#rotation, q[at]!, q[at + 1]!, q[at + 2]!, q[at + 3]!);
    else if (dofKind[dof] === DofKind.hinge) {
      const s = Math.sin(0.5 * q[at]!);
      const [x, y, z] = [dofAxis[dof * 3]!, dofAxis[dof * 3 + 1]!, dofAxis[dof * 3 + 2]!];
      multiply(this.#rotation, x * s, y * s, z * s, Math.cos(0.5 * q[at]!));
    }
  }
}

const turnedFrame = new Float64Array(3);
const keptRotation = new Float64Array(4);

function rangeOf(nature: JointNature, row: number): readonly [number, number] {
  return row === 0 ? nature.bend : row === 1 ? nature.side : nature.twist;
}

/** How far a value is above a range, or below it as a negative number; 0 inside. */
function outside(value: number, [min, max]: readonly [number, number]): number {
  return value > max ? value - max : value < min ? value - min : 0;
}

/** Multiplies a quaternion from the right, in place. */
function multiply(q: Float64Array, x: number, y: number, z: number, w: number): void {
  const ax = q[0]!;
  const ay = q[1]!;
  const az = q[2]!;
  const aw = q[3]!;
  q[0] = aw * x + ax * w + ay * z - az * y;
  q[1] = aw * y - ax * z + ay * w + az * x;
  q[2] = aw * z + ax * y - ay * x + az * w;
  q[3] = aw * w - ax * x - ay * y - az * z;
}

/** Rotates a vector by a unit quaternion, in place. */
function rotateVector(q: Float64Array, v: Float64Array): void {
  const [x, y, z] = [v[0]!, v[1]!, v[2]!];
  const tx = 2 * (q[1]! * z - q[2]! * y);
  const ty = 2 * (q[2]! * x - q[0]! * z);
  const tz = 2 * (q[0]! * y - q[1]! * x);
  v[0] = x + q[3]! * tx + q[1]! * tz - q[2]! * ty;
  v[1] = y + q[3]! * ty + q[2]! * tx - q[0]! * tz;
  v[2] = z + q[3]! * tz + q[0]! * ty - q[1]! * tx;
}
