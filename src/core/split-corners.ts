import { firstEqualTuples } from './equal-tuples.ts';

/** The render vertices of a mesh; the first `pointCount` of them are its points. */
export interface SplitCorners {
  /** (vertexCount) */
  readonly pointOf: Uint32Array;
  /** (vertexCount) the first corner of each render vertex, or -1 if no face uses it. */
  readonly cornerOf: Int32Array;
  /** (cornerCount) the render vertex of each corner. */
  readonly indices: Uint32Array;
}

/**
 * A point's first corner uses the point's own vertex. Each further corner that differs in any of
 * the `values` (cornerCount each; equal values have equal indices) adds a vertex.
 */
export function splitCorners(
  cornerPoints: Uint32Array,
  pointCount: number,
  values: readonly Int32Array[],
): SplitCorners {
  const firstCornerOf = new Int32Array(pointCount).fill(-1);
  const seams: number[] = [];
  for (let corner = 0; corner < cornerPoints.length; corner++) {
    const point = cornerPoints[corner]!;
    const first = firstCornerOf[point]!;
    if (first === -1) firstCornerOf[point] = corner;
    else if (!areEqual(values, first, corner)) seams.push(corner);
  }
  const indices = cornerPoints.slice();
  const firstEqual = firstEqualCorners(seams, cornerPoints, values);
  const added = seams.filter((_, i) => firstEqual[i] === i);
  const pointOf = new Uint32Array(pointCount + added.length);
  const cornerOf = new Int32Array(pointOf.length);
  cornerOf.set(firstCornerOf);
  for (let point = 0; point < pointCount; point++) pointOf[point] = point;
  added.forEach((corner, i) => {
    pointOf[pointCount + i] = cornerPoints[corner]!;
    cornerOf[pointCount + i] = corner;
  });
  let vertex = pointCount;
  seams.forEach((corner, i) => {
    const equal = firstEqual[i]!;
    indices[corner] = equal === i ? vertex++ : indices[seams[equal]!]!;
  });
  return { pointOf, cornerOf, indices };
}

function areEqual(values: readonly Int32Array[], a: number, b: number): boolean {
  for (let i = 0; i < values.length; i++) if (values[i]![a] !== values[i]![b]) return false;
  return true;
}

/** For each of these corners, which of them is the first with the same point and values. */
function firstEqualCorners(
  corners: readonly number[],
  cornerPoints: Uint32Array,
  values: readonly Int32Array[],
): Int32Array {
  const columns = [cornerPoints, ...values];
  const tuples = new Int32Array(corners.length * columns.length);
  columns.forEach((column, k) => {
    for (let i = 0; i < corners.length; i++) {
      tuples[i * columns.length + k] = column[corners[i]!]!;
    }
  });
  return firstEqualTuples(tuples, columns.length);
}
