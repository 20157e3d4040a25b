import type { RotationChart } from './chart.ts';
import { exponential, nearestShell } from './quaternions.ts';

/** Below this sine of half its angle a rotation has no axis that can be relied on. */
const least = 1e-14;

/**
 * The axis of the rotation times its angle, in the joint's frame (Grassia 1998, "Practical
 * parameterization of rotations using the exponential map"). The rotations by a full turn are one
 * rotation, but a whole sphere of vectors.
 */
export const rotationVectorChart: RotationChart = {
  id: 'rotation-vector',
  label: 'Rotation vector',
  names: ['X', 'Y', 'Z'],
  read([x, y, z, w], near) {
    const sine = Math.hypot(x, y, z);
    const direction = sine > least ? [x / sine, y / sine, z / sine] : [0, 0, 0];
    return nearestShell(direction, 2 * Math.atan2(sine, w), near);
  },
  rotationOf: exponential,
  stretchAt(values) {
    const half = Math.hypot(...values) / 2;
    return half < 1e-6 ? 1 : Math.max(1, half / Math.abs(Math.sin(half)));
  },
  foldText: () =>
    'Near a full turn: every axis gives the same rotation here, so the axis means nothing',
};
