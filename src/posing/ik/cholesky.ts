/**
 * Solves `(matrix + diagonal) x = right` for the rows and columns that are free, by the Cholesky
 * factorization L Lᵀ. Returns false, and leaves x as it is, if that matrix is not positive definite.
 *
 * @param matrix (size × size) symmetric; only its lower triangle is read
 * @param diagonal (size) is added to the matrix's diagonal
 * @param indices the rows and columns that are free, ascending; the first `count` are used
 * @param factor (size × size) scratch
 * @param x (size) only its free values are written
 */
export function solveDefinite(
  matrix: Float64Array,
  diagonal: Float64Array,
  right: Float64Array,
  indices: Uint16Array,
  count: number,
  factor: Float64Array,
  x: Float64Array,
): boolean {
  const size = right.length;
  for (let row = 0; row < count; row++) {
    const r = row * size;
    const from = indices[row]! * size;
    for (let column = 0; column <= row; column++) {
      const c = column * size;
      const own = matrix[from + indices[column]!]!;
      let sum = row === column ? own + diagonal[indices[row]!]! : own;
      const scale = Math.abs(sum);
      for (let k = 0; k < column; k++) sum -= factor[r + k]! * factor[c + k]!;
      if (row !== column) factor[r + column] = sum / factor[c + column]!;
      else if (sum > rounding * scale) factor[r + row] = Math.sqrt(sum);
      else return false;
    }
  }
  for (let row = 0; row < count; row++) {
    let rest = right[indices[row]!]!;
    for (let k = 0; k < row; k++) rest -= factor[row * size + k]! * x[indices[k]!]!;
    x[indices[row]!] = rest / factor[row * size + row]!;
  }
  for (let row = count - 1; row >= 0; row--) {
    let rest = x[indices[row]!]!;
    for (let k = row + 1; k < count; k++) rest -= factor[k * size + row]! * x[indices[k]!]!;
    x[indices[row]!] = rest / factor[row * size + row]!;
  }
  return true;
}

/**
 * Finds a direction along which the quadratic form of a symmetric matrix is negative: where the
 * Cholesky factorization fails at a row, the vector that is 1 there, and in the rows before it what
 * makes the form least. Returns false if there is none, because the matrix is positive definite.
 *
 * @param matrix (size × size) only its lower triangle is read
 * @param order all rows and columns, in the order in which they are eliminated
 * @param factor (size × size) scratch
 * @param direction (size) written
 */
export function negativeDirection(
  matrix: Float64Array,
  order: Uint16Array,
  factor: Float64Array,
  direction: Float64Array,
): boolean {
  const size = direction.length;
  direction.fill(0);
  for (let row = 0; row < size; row++) {
    const r = row * size;
    const own = order[row]!;
    let pivot = matrix[own * size + own]!;
    for (let column = 0; column < row; column++) {
      const c = column * size;
      const other = order[column]!;
      let sum = matrix[own > other ? own * size + other : other * size + own]!;
      for (let k = 0; k < column; k++) sum -= factor[r + k]! * factor[c + k]!;
      const element = sum / factor[c + column]!;
      factor[r + column] = element;
      pivot -= element * element;
    }
    if (pivot > 0) {
      factor[r + row] = Math.sqrt(pivot);
      continue;
    }
    direction[own] = 1;
    for (let column = row - 1; column >= 0; column--) {
      let rest = -factor[r + column]!;
      for (let k = column + 1; k < row; k++)
        rest -= factor[k * size + column]! * direction[order[k]!]!;
      direction[order[column]!] = rest / factor[column * size + column]!;
    }
    return true;
  }
  return false;
}

/** A pivot that is smaller than this part of its diagonal element is lost in rounding. */
const rounding = 1e-13;
