import type { IkObjective } from './objective.ts';

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
  return eigenvalues(products)
    .sort((a, b) => b - a)
    .slice(0, space.columnCount)
    .map((value) => Math.sqrt(Math.max(value, 0)));
}

/** The eigenvalues of a small symmetric matrix, which is overwritten (Jacobi 1846, cyclic sweeps). */
function eigenvalues(matrix: number[][]): number[] {
  const size = matrix.length;
  for (let sweep = 0; sweep < 30; sweep++) {
    let off = 0;
    for (let p = 0; p < size; p++)
      for (let q = p + 1; q < size; q++) {
        off += Math.abs(matrix[p]![q]!);
        rotate(matrix, p, q);
      }
    if (off === 0) break;
  }
  return matrix.map((row, i) => row[i]!);
}

/** Makes the element (p, q) zero by a rotation of rows and columns p and q. */
function rotate(matrix: number[][], p: number, q: number): void {
  const element = matrix[p]![q]!;
  if (element === 0) return;
  const half = (matrix[q]![q]! - matrix[p]![p]!) / (2 * element);
  const tangent = (half < 0 ? -1 : 1) / (Math.abs(half) + Math.sqrt(half * half + 1));
  const cosine = 1 / Math.sqrt(tangent * tangent + 1);
  const sine = tangent * cosine;
  for (const row of matrix) {
    const [a, b] = [row[p]!, row[q]!];
    row[p] = cosine * a - sine * b;
    row[q] = sine * a + cosine * b;
  }
  const [rowP, rowQ] = [matrix[p]!, matrix[q]!];
  for (let i = 0; i < rowP.length; i++) {
    const [a, b] = [rowP[i]!, rowQ[i]!];
    rowP[i] = cosine * a - sine * b;
    rowQ[i] = sine * a + cosine * b;
  }
}
