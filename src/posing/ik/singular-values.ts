import type { IkObjective } from './objective.ts';
import { symmetricEigen } from './symmetric-eigen.ts';

/**
 * The singular values of the Jacobian of all goals' places, in lengths of each goal's chain per
 * radian, the largest first: the square roots of the eigenvalues of J Jᵀ. A small one is a direction
 * in which the points can hardly move. The objective's kinematics must be up to date.
 */
export function singularValues(objective: IkObjective): number[] {
  const { goals, chains, kinematics, jacobian, space } = objective;
  const size = goals.length * 3;
  const rows = Array.from({ length: size }, () => new Float64Array(space.columnCount));
  goals.forEach((_, goal) => {
    objective.writeJacobian(goal);
    for (const column of kinematics.columnsOf[goal]!)
      for (let axis = 0; axis < 3; axis++)
        rows[goal * 3 + axis]![column] = jacobian[column * 3 + axis]! / chains[goal]!.length;
  });
  const products = rows.map((a) => rows.map((b) => a.reduce((sum, x, i) => sum + x * b[i]!, 0)));
  return symmetricEigen(products)
    .slice(0, space.columnCount)
    .map(({ value }) => Math.sqrt(Math.max(value, 0)));
}
