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
  const size = values.length + 1;
  const tuples = new Int32Array(cornerPoints.length * size);
  [cornerPoints, ...values].forEach((column, i) => {
    for (let corner = 0; corner < column.length; corner++)
      tuples[corner * size + i] = column[corner]!;
  });
  const firstEqual = firstEqualTuples(tuples, size);
  const pointOf = Array.from({ length: pointCount }, (_, point) => point);
  const cornerOf = new Array<number>(pointCount).fill(-1);
  const indices = cornerPoints.slice();
  cornerPoints.forEach((point, corner) => {
    const equal = firstEqual[corner]!;
    if (equal < corner) indices[corner] = indices[equal]!;
    else if (cornerOf[point] === -1) cornerOf[point] = corner;
    else {
      indices[corner] = pointOf.length;
      pointOf.push(point);
      cornerOf.push(corner);
    }
  });
  return { pointOf: Uint32Array.from(pointOf), cornerOf: Int32Array.from(cornerOf), indices };
}
