/**
 * Something that a solve should respect as far as the goals allow, as rows of the least squares: its
 * cost is half the sum of its rows' squares. To add one, write a class and a line in objective.ts.
 */
export interface SoftTask {
  /** The cost in a pose. */
  cost(q: Float64Array): number;
  /**
   * Adds `weight` times the gradient Jᵀ r and the matrix Jᵀ J of the rows r, whose derivatives by the
   * columns of the tangent space are J.
   *
   * @param gradient (columnCount)
   * @param matrix (columnCount × columnCount) only its lower triangle is read
   */
  accumulate(q: Float64Array, weight: number, gradient: Float64Array, matrix: Float64Array): void;
}
