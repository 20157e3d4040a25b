import { mat4, quat } from 'gl-matrix';
import { type EulerProduct, extractEuler } from '../../core/euler.ts';
import { axisDofs } from '../../core/pose.ts';
import { DofKind, type Skeleton } from '../../core/skeleton.ts';

export type Angles = readonly [x: number, y: number, z: number];

/** The rotation of angles about x, y, z, as a unit quaternion xyzw. */
export function turnOf([x, y, z]: Angles, product: EulerProduct): quat {
  const rotation = quat.identity(new Float64Array(4));
  if (product === 'xyz') {
    quat.rotateX(rotation, rotation, x);
    quat.rotateY(rotation, rotation, y);
    quat.rotateZ(rotation, rotation, z);
  } else {
    quat.rotateZ(rotation, rotation, z);
    quat.rotateY(rotation, rotation, y);
    quat.rotateX(rotation, rotation, x);
  }
  return rotation;
}

/** The angles of a rotation that are nearest to others. */
export function anglesOf(rotation: ArrayLike<number>, product: EulerProduct, near: Angles): Angles {
  const [x, y, z, w] = [rotation[0]!, rotation[1]!, rotation[2]!, rotation[3]!];
  return extractEuler(
    mat4.fromRotationTranslation(new Float64Array(16), [x, y, z, w], [0, 0, 0]),
    product,
    near,
  );
}

/** The angle in radians from one rotation to another. */
export function turnBetween(a: ArrayLike<number>, b: ArrayLike<number>): number {
  let [sum, difference] = [0, 0];
  for (let i = 0; i < 4; i++) {
    sum += (a[i]! + b[i]!) ** 2;
    difference += (a[i]! - b[i]!) ** 2;
  }
  // Unlike the arc cosine of the product, this is exact where they are nearly equal.
  const [long, short] = [Math.max(sum, difference), Math.min(sum, difference)];
  return 4 * Math.atan2(Math.sqrt(short), Math.sqrt(long));
}

/** The order of a joint's turns, if it has three hinges about the coordinate axes and no ball. */
export function productOf(skeleton: Skeleton, joint: number): EulerProduct | null {
  const from = skeleton.dofStart[joint]!;
  const kinds = [...skeleton.dofKind.subarray(from, skeleton.dofStart[joint + 1])];
  const hinges = axisDofs(skeleton, joint).filter(({ kind }) => kind === DofKind.hinge);
  const turning = kinds.filter((kind) => kind !== DofKind.slide);
  if (turning.length !== 3 || hinges.length !== 3) return null;
  const order = hinges.map(({ axis }) => 'xyz'[axis]).join('');
  return order === 'xyz' || order === 'zyx' ? order : null;
}
