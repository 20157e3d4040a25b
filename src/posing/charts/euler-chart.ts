import { mat4, vec3 } from 'gl-matrix';
import { extractEuler } from '../../core/euler.ts';
import type { Quaternion } from '../../core/motion/clip-parts.ts';
import type { RotationChart } from './chart.ts';
import { aboutAxis, noTurn, product } from './quaternions.ts';

type Axis = readonly [number, number, number];

/** A hinge of a joint, or one of the three angles at which a ball is shown. */
export interface EulerAxis {
  readonly name: string;
  /** Unit, joint frame; at right angles to the joint's others. */
  readonly axis: Axis;
}

/**
 * The angles of up to three hinges at right angles, R = R₁ · R₂ · R₃ in their order. Three can reach
 * any rotation; the rotations that are read of fewer must be of those that they reach.
 */
export function eulerChart(hinges: readonly EulerAxis[]): RotationChart {
  const axes = completed(hinges.map(({ axis }) => axis));
  const [a, b, c] = axes as [Axis, Axis, Axis];
  const handedness = vec3.dot(vec3.cross(new Float64Array(3), a, b), c) > 0 ? 1 : -1;
  const names = hinges.map(({ name }) => name);
  return {
    id: 'euler',
    label: 'Euler angles',
    names,
    read(rotation, near) {
      // In the frame of the axes the product is Rx · Ry · Rz; a reflection reverses the angles.
      const from = [0, 1, 2].map((i) => handedness * (near[i] ?? 0));
      const angles = extractEuler(inFrame(rotation, axes), 'xyz', from);
      return hinges.map((_, i) => handedness * angles[i]!);
    },
    rotationOf: (values) =>
      hinges.reduce<Quaternion>(
        (sum, { axis }, i) => product(sum, aboutAxis(axis, values[i]!)),
        noTurn,
      ),
    stretchAt: (values) => (hinges.length < 3 ? 1 : 1 / Math.abs(Math.cos(values[1]!))),
    foldText: () => `Gimbal lock: ${names[0]!} and ${names[2]!} turn about one axis`,
  };
}

/** Axes that complete one or two to three at right angles. */
function completed(axes: readonly Axis[]): readonly Axis[] {
  const all = [...axes];
  const units = [0, 1, 2].map((at) => [0, 1, 2].map((i) => (i === at ? 1 : 0)) as unknown as Axis);
  for (const unit of units) {
    const isFree = all.every((axis) => Math.abs(vec3.dot(axis, unit)) < 1e-9);
    if (all.length < 3 && isFree) all.push(unit);
  }
  return all;
}

/** The first eleven elements of the column-major matrix Bᵀ · R · B; the columns of B are the axes. */
function inFrame(rotation: Quaternion, axes: readonly Axis[]): number[] {
  const matrix = mat4.fromRotationTranslation(new Float64Array(16), [...rotation], [0, 0, 0]);
  const turned = axes.map((axis) => vec3.transformMat4(new Float64Array(3), axis, matrix));
  return turned
    .flatMap((column) => [...axes.map((axis) => vec3.dot(axis, column)), 0])
    .slice(0, 11);
}
