import { firstEqualTuples } from './equal-tuples.ts';

/** The render vertices of a mesh; the first `pointCount` are its points. */
export interface SplitCorners {
  /** (vertexCount) */
  readonly pointOf: Uint32Array;
  /** (vertexCount) the first corner of each render vertex, -1 where it is none. */
  readonly cornerOf: Int32Array;
  /** (cornerCount) render vertices. */
  readonly indices: Uint32Array;
}

/**
 * A point's first corner takes the point's own vertex; each further one that differs in any of the
 * `values` (cornerCount each, equal ones by one index) adds a vertex.
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
