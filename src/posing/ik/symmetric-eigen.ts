/** An eigenvalue of a symmetric matrix, with a unit vector. */
export interface Eigen {
  readonly value: number;
  readonly vector: readonly number[];
}

const mostSweeps = 30;

/**
 * The eigenvalues and eigenvectors of a small symmetric matrix, the largest value first, by cyclic
 * sweeps of rotations that make one element after the other zero (Jacobi 1846).
 */
export function symmetricEigen(matrix: readonly (readonly number[])[]): Eigen[] {
  const size = matrix.length;
  const rows = matrix.map((row) => [...row]);
  /** Its rows become the eigenvectors. */
  const vectors = rows.map((_, i) => rows.map((__, j) => (i === j ? 1 : 0)));
  for (let sweep = 0; sweep < mostSweeps; sweep++) {
    let off = 0;
    for (let p = 0; p < size; p++) {
      for (let q = p + 1; q < size; q++) {
        off += Math.abs(rows[p]![q]!);
        rotate(rows, vectors, p, q);
      }
    }
    if (off === 0) break;
  }
  return vectors
    .map((vector, i) => ({ vector, value: rows[i]![i]! }))
    .sort((a, b) => b.value - a.value);
}

/** Makes the element (p, q) zero by a rotation of rows and columns p and q. */
function rotate(rows: number[][], vectors: number[][], p: number, q: number): void {
  const element = rows[p]![q]!;
  if (element === 0) return;
  const theta = (rows[q]![q]! - rows[p]![p]!) / (2 * element);
  const tangent = (theta < 0 ? -1 : 1) / (Math.abs(theta) + Math.hypot(theta, 1));
  const cosine = 1 / Math.hypot(tangent, 1);
  const sine = tangent * cosine;
  for (const row of rows) {
    const [a, b] = [row[p]!, row[q]!];
    row[p] = cosine * a - sine * b;
    row[q] = sine * a + cosine * b;
  }
  for (const matrix of [rows, vectors]) {
    const [from, to] = [matrix[p]!, matrix[q]!];
    for (let i = 0; i < from.length; i++) {
      const [a, b] = [from[i]!, to[i]!];
      from[i] = cosine * a - sine * b;
      to[i] = sine * a + cosine * b;
    }
  }
  // Rounding leaves a trace that later sweeps would chase.
  rows[p]![q] = 0;
  rows[q]![p] = 0;
}
