import { jointRange } from '../../core/pose.ts';
import { DofKind, type Skeleton } from '../../core/skeleton.ts';

/**
 * The directions in which the values q of some joints can move: one column for each slide and hinge,
 * and three for each ball, which rotates about the axes of its parent's frame. Values that their
 * limits lock have no column.
 */
export interface TangentSpace {
  readonly columnCount: number;
  /** (columnCount) the joint of each column, ascending. */
  readonly joints: Uint16Array;
  /** (columnCount) the degree of freedom of each column, ascending. */
  readonly dofs: Uint16Array;
  /** (columnCount) the `DofKind` of each column. */
  readonly kinds: Uint8Array;
  /** (columnCount) the index in q of its value; of a ball, of its quaternion's x. */
  readonly values: Uint32Array;
  /** (columnCount) 0 to 2 for the three columns of a ball, otherwise 0. */
  readonly axes: Uint8Array;
  /** (columnCount) the limits; those of a ball are infinite. */
  readonly min: Float64Array;
  readonly max: Float64Array;
}

export function tangentSpace(skeleton: Skeleton, joints: readonly number[]): TangentSpace {
  const columns: { joint: number; dof: number; axis: number }[] = [];
  for (const joint of joints) {
    for (let dof = skeleton.dofStart[joint]!; dof < skeleton.dofStart[joint + 1]!; dof++) {
      const value = skeleton.dofQ[dof]!;
      if (skeleton.dofKind[dof] === DofKind.ball)
        for (let axis = 0; axis < 3; axis++) columns.push({ joint, dof, axis });
      else if (skeleton.qMin[value]! < skeleton.qMax[value]!) columns.push({ joint, dof, axis: 0 });
    }
  }
  const { dofKind, dofQ, qMin, qMax } = skeleton;
  const values = Uint32Array.from(columns, ({ dof }) => dofQ[dof]!);
  const isBall = (column: number): boolean => dofKind[columns[column]!.dof] === DofKind.ball;
  return {
    columnCount: columns.length,
    joints: Uint16Array.from(columns, ({ joint }) => joint),
    dofs: Uint16Array.from(columns, ({ dof }) => dof),
    kinds: Uint8Array.from(columns, ({ dof }) => dofKind[dof]!),
    values,
    axes: Uint8Array.from(columns, ({ axis }) => axis),
    min: Float64Array.from(values, (value, column) => (isBall(column) ? -Infinity : qMin[value]!)),
    max: Float64Array.from(values, (value, column) => (isBall(column) ? Infinity : qMax[value]!)),
  };
}

/**
 * Writes q moved by the tangent vector v: values are added and clamped to their limits, and a ball
 * is rotated by the rotation vector of its three columns, `exp(v) · ball`.
 *
 * @param q (qCount) not written unless it is `out`
 * @param v (columnCount)
 * @param out (qCount) only the values of the columns are written
 */
export function integrate(
  space: TangentSpace,
  q: Float64Array,
  v: Float64Array,
  out: Float64Array,
): void {
  const { columnCount, kinds, values, min, max } = space;
  for (let column = 0; column < columnCount; column++) {
    const at = values[column]!;
    if (kinds[column] !== DofKind.ball) {
      out[at] = Math.min(Math.max(q[at]! + v[column]!, min[column]!), max[column]!);
      continue;
    }
    rotateBall(q, at, v[column]!, v[column + 1]!, v[column + 2]!, out);
    column += 2;
  }
}

/**
 * Writes the tangent vector that leads from `from` to `to`: `integrate(from, v)` is `to`, up to the
 * sign of quaternions. A ball takes the shorter way.
 *
 * @param v (columnCount) written
 */
export function difference(
  space: TangentSpace,
  from: Float64Array,
  to: Float64Array,
  v: Float64Array,
): void {
  const { columnCount, kinds, values } = space;
  for (let column = 0; column < columnCount; column++) {
    const at = values[column]!;
    if (kinds[column] !== DofKind.ball) {
      v[column] = to[at]! - from[at]!;
      continue;
    }
    ballDifference(from, to, at, v, column);
    column += 2;
  }
}

/** Whether two poses have the same values in all joints of a list. */
export function sameValues(
  skeleton: Skeleton,
  joints: readonly number[],
  a: Float64Array,
  b: Float64Array,
): boolean {
  return joints.every((joint) => {
    const [from, to] = jointRange(skeleton, joint);
    for (let i = from; i < to; i++) if (a[i] !== b[i]) return false;
    return true;
  });
}

function rotateBall(
  q: Float64Array,
  at: number,
  vx: number,
  vy: number,
  vz: number,
  out: Float64Array,
): void {
  const angle = Math.sqrt(vx * vx + vy * vy + vz * vz);
  // sin(angle / 2) / angle is 1/2 where the angle is too small to divide by.
  const scale = angle > 1e-12 ? Math.sin(0.5 * angle) / angle : 0.5;
  const x = vx * scale;
  const y = vy * scale;
  const z = vz * scale;
  const w = Math.cos(0.5 * angle);
  const bx = q[at]!;
  const by = q[at + 1]!;
  const bz = q[at + 2]!;
  const bw = q[at + 3]!;
  const ox = w * bx + x * bw + y * bz - z * by;
  const oy = w * by - x * bz + y * bw + z * bx;
  const oz = w * bz + x * by - y * bx + z * bw;
  const ow = w * bw - x * bx - y * by - z * bz;
  const unit = 1 / Math.sqrt(ox * ox + oy * oy + oz * oz + ow * ow);
  out[at] = ox * unit;
  out[at + 1] = oy * unit;
  out[at + 2] = oz * unit;
  out[at + 3] = ow * unit;
}

/** Writes log(to · from⁻¹), the rotation vector in the frame before the ball. */
function ballDifference(
  from: Float64Array,
  to: Float64Array,
  at: number,
  v: Float64Array,
  column: number,
): void {
  const ax = -from[at]!;
  const ay = -from[at + 1]!;
  const az = -from[at + 2]!;
  const aw = from[at + 3]!;
  const bx = to[at]!;
  const by = to[at + 1]!;
  const bz = to[at + 2]!;
  const bw = to[at + 3]!;
  const x = bw * ax + bx * aw + by * az - bz * ay;
  const y = bw * ay - bx * az + by * aw + bz * ax;
  const z = bw * az + bx * ay - by * ax + bz * aw;
  const w = bw * aw - bx * ax - by * ay - bz * az;
  const sine = Math.sqrt(x * x + y * y + z * z);
  const angle = 2 * Math.atan2(sine, Math.abs(w));
  const scale = (sine > 1e-12 ? angle / sine : 2) * (w < 0 ? -1 : 1);
  v[column] = x * scale;
  v[column + 1] = y * scale;
  v[column + 2] = z * scale;
}
