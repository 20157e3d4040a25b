import { DofKind } from '../../core/skeleton.ts';
import { GoalKinematics } from './goal-kinematics.ts';
import { type LabChain, problemOf } from './lab-chain.ts';
import type { Vector3 } from './problem.ts';
import { symmetricEigen } from './symmetric-eigen.ts';
import { tangentSpace } from './tangent-space.ts';

/** A direction in which turns of the joints can move the effector. */
export interface EllipsoidAxis {
  /** A unit vector in the character's space. */
  readonly direction: Vector3;
  /** A singular value of the Jacobian: lengths of the chain that the effector moves per radian. */
  readonly size: number;
}

/**
 * Returns the axes of the manipulability ellipsoid, the longest first: the places to which turns of a
 * total size of 1 (a unit vector of all values) would take the effector if it moved on straight. They
 * are the left singular vectors and the singular values of its Jacobian J, of which a hinge about the
 * unit axis a through c has the column a × (e − c), computed as the eigenvectors of J · Jᵀ and the
 * roots of its eigenvalues (Yoshikawa 1985, "Manipulability of robotic mechanisms").
 */
export function manipulability(chain: LabChain, q: Float64Array): EllipsoidAxis[] {
  const { skeleton, moving } = chain;
  const { goals } = problemOf(chain, q, [0, 0, 0]);
  const space = tangentSpace(skeleton, moving);
  const kinematics = new GoalKinematics(skeleton, goals, space, q);
  kinematics.update(q);
  const { axes, origins, points } = kinematics;
  const squared = [0, 0, 0].map(() => [0, 0, 0]);
  for (let column = 0; column < space.columnCount; column++) {
    const at = column * 3;
    const [ax, ay, az] = [axes[at]!, axes[at + 1]!, axes[at + 2]!];
    const [x, y, z] = [
      points[0]! - origins[at]!,
      points[1]! - origins[at + 1]!,
      points[2]! - origins[at + 2]!,
    ];
    const moved =
      space.kinds[column] === DofKind.slide
        ? [ax, ay, az]
        : [ay * z - az * y, az * x - ax * z, ax * y - ay * x];
    squared.forEach((row, i) => row.forEach((_, j) => (row[j]! += moved[i]! * moved[j]!)));
  }
  return symmetricEigen(squared).map(({ vector: [x, y, z], value }) => {
    return { direction: [x!, y!, z!], size: Math.sqrt(Math.max(0, value)) / chain.length };
  });
}
