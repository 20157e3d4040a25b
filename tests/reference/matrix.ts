/**
 * A float64 oracle, written from the text of the 6.837 handout. It shares nothing with `src`: it
 * uses plain arrays, no library, and the simplest way to compute each result. Matrices are arrays
 * of rows and vectors are columns, so that `multiply(a, b)` applies b first.
 */
export type Vector = readonly number[];
export type Matrix = readonly (readonly number[])[];

export const identity: Matrix = [
  [1, 0, 0, 0],
  [0, 1, 0, 0],
  [0, 0, 1, 0],
  [0, 0, 0, 1],
];

export function multiply(a: Matrix, b: Matrix): Matrix {
  return a.map((row) =>
    b[0]!.map((_, column) => row.reduce((sum, value, k) => sum + value * b[k]![column]!, 0)),
  );
}

export function translation([x, y, z]: Vector): Matrix {
  return [
    [1, 0, 0, x!],
    [0, 1, 0, y!],
    [0, 0, 1, z!],
    [0, 0, 0, 1],
  ];
}

/**
 * Rodrigues' formula: rotates by `angle` about a unit axis, counterclockwise seen from its tip.
 */
export function rotationAbout([x, y, z]: Vector, angle: number): Matrix {
  const k: Matrix = [
    [0, -z!, y!],
    [z!, 0, -x!],
    [-y!, x!, 0],
  ];
  const squared = multiply(k, k);
  return identity.map((row, r) =>
    row.map((one, c) =>
      r < 3 && c < 3
        ? one + Math.sin(angle) * k[r]![c]! + (1 - Math.cos(angle)) * squared[r]![c]!
        : one,
    ),
  );
}

/** The rotation of a unit quaternion x, y, z, w. */
export function rotationOf([x, y, z, w]: Vector): Matrix {
  const half = Math.hypot(x!, y!, z!);
  if (half === 0) return identity;
  return rotationAbout([x! / half, y! / half, z! / half], 2 * Math.atan2(half, w!));
}

/** The matrix times (x, y, z, last): last is 1 for a point and 0 for a direction. */
export function transform(matrix: Matrix, vector: Vector, last = 1): number[] {
  const column = [...vector, last];
  return matrix
    .slice(0, 3)
    .map((row) => row.reduce((sum, value, k) => sum + value * column[k]!, 0));
}

/** Gauss-Jordan elimination with partial pivoting; throws for a singular matrix. */
export function inverse(matrix: Matrix): Matrix {
  const size = matrix.length;
  const rows = matrix.map((row, r) => [...row, ...row.map((_, c) => (r === c ? 1 : 0))]);
  for (let column = 0; column < size; column++) {
    const below = rows.slice(column).map((row) => Math.abs(row[column]!));
    const pivot = column + below.indexOf(Math.max(...below));
    [rows[column], rows[pivot]] = [rows[pivot]!, rows[column]!];
    const scale = rows[column]![column]!;
    if (scale === 0) throw new Error('a singular matrix has no inverse');
    const scaled = rows[column]!.map((value) => value / scale);
    rows.forEach((row, r) => {
      const factor = row[column]!;
      rows[r] = r === column ? scaled : row.map((value, c) => value - factor * scaled[c]!);
    });
  }
  return rows.map((row) => row.slice(size));
}

export function transpose(matrix: Matrix): Matrix {
  return matrix[0]!.map((_, column) => matrix.map((row) => row[column]!));
}

export function unit(vector: Vector): number[] {
  const length = Math.hypot(...vector);
  return vector.map((value) => value / length);
}
