import {
  inverse,
  type Matrix,
  multiply,
  transform,
  transpose,
  unit,
  type Vector,
} from './matrix.ts';
import { type Influence, skinningMatrix, type Transforms, type Vertex } from './skinned-vertex.ts';

/**
 * Centers of rotation in float64, written from Le and Hodgins 2016, "Real-time skeletal skinning
 * with optimized centers of rotation": every sum runs over the whole surface, and over all joints.
 */

const sigma = 0.1;

/** The center of each point (equation 1), or null where no triangle is similar to the point. */
export function rotationCenters(
  points: readonly Vector[],
  triangles: readonly (readonly number[])[],
  rows: readonly (readonly Influence[])[],
): (number[] | null)[] {
  const weights = rows.map((row) => positiveWeights(row));
  const pieces = triangles.map((corners) => {
    const [a, b, c] = corners.map((corner) => points[corner]!);
    const mean = new Map<number, number>();
    for (const corner of corners) {
      for (const [joint, weight] of weights[corner]!) {
        mean.set(joint, (mean.get(joint) ?? 0) + weight / 3);
      }
    }
    const place = [0, 1, 2].map((axis) => (a![axis]! + b![axis]! + c![axis]!) / 3);
    return { mean, place, area: Math.hypot(...cross(minus(b!, a!), minus(c!, a!))) / 2 };
  });
  return weights.map((own) => {
    const sums = [0, 0, 0];
    let total = 0;
    for (const { mean, place, area } of pieces) {
      const share = area * similarity(own, mean);
      total += share;
      place.forEach((value, axis) => (sums[axis]! += share * value));
    }
    return total === 0 ? null : sums.map((sum) => sum / total);
  });
}

/** Equation 4: s(w, v) = Σ over j ≠ k of wⱼ wₖ vⱼ vₖ exp(−(wⱼ vₖ − wₖ vⱼ)² / σ²). */
function similarity(w: ReadonlyMap<number, number>, v: ReadonlyMap<number, number>): number {
  const shared = [...w].flatMap(([joint, own]) => (v.has(joint) ? [[own, v.get(joint)!]] : []));
  let sum = 0;
  for (const [j, [wj, vj]] of shared.entries()) {
    for (const [k, [wk, vk]] of shared.entries()) {
      if (j === k) continue;
      sum += wj! * wk! * vj! * vk! * Math.exp(-((wj! * vk! - wk! * vj!) ** 2) / sigma ** 2);
    }
  }
  return sum;
}

/** p′ = R(q) S (p − p*) + A p* + t; without a center, p′ = A p + t. */
export function turnedAboutCenter(vertex: Vertex, transforms: Transforms): number[] {
  const { blended, turned } = motionOf(vertex, transforms);
  const { center } = vertex;
  if (!center) return transform(blended, vertex.position);
  const moved = transform(blended, center);
  const arm = minus(vertex.position, center);
  return turned.map((row, axis) => moved[axis]! + row.reduce((sum, m, k) => sum + m * arm[k]!, 0));
}

/** The normal follows the matrix that is applied to the point, by its inverse transpose. */
export function normalAboutCenter(vertex: Vertex, transforms: Transforms): Vector {
  const { blended, turned } = motionOf(vertex, transforms);
  const matrix = vertex.center ? turned : blended.slice(0, 3).map((row) => row.slice(0, 3));
  return unit(
    transpose(inverse(matrix)).map((row) =>
      row.reduce((sum, m, k) => sum + m * vertex.normal[k]!, 0),
    ),
  );
}

/** [A t] of linear blend, and R(q) S: the mean rotation after the weighted mean of the stretch. */
function motionOf(vertex: Vertex, transforms: Transforms): { blended: Matrix; turned: Matrix } {
  const weights = [...positiveWeights(vertex.influences)];
  const row: readonly Influence[] = weights.length > 0 ? weights : [[transforms.firstRoot, 1]];
  const parts = row.map(([joint, weight]) => ({ weight, ...partsOf(joint, transforms) }));
  const heaviest = parts.reduce((best, next) => (next.weight > best.weight ? next : best));
  const q = [0, 0, 0, 0];
  for (const { weight, quaternion } of parts) {
    const isOpposite = dot(quaternion, heaviest.quaternion) < 0;
    quaternion.forEach((value, i) => (q[i]! += weight * (isOpposite ? -value : value)));
  }
  const blend = (matrices: readonly Matrix[]): Matrix =>
    matrices[0]!.map((line, r) =>
      line.map((_, c) =>
        parts.reduce((sum, { weight }, i) => sum + weight * matrices[i]![r]![c]!, 0),
      ),
    );
  const rotation = turn(unit(q));
  const total = parts.reduce((sum, { weight }) => sum + weight, 0);
  const stretch = blend(parts.map((part) => part.stretch)).map((line) =>
    line.map((value) => value / total),
  );
  return {
    blended: blend(parts.map(({ matrix }) => matrix)),
    turned: multiply(rotation, stretch),
  };
}

interface Parts {
  readonly matrix: Matrix;
  readonly stretch: Matrix;
  readonly quaternion: Vector;
}

const knownParts = new WeakMap<Transforms, Map<number, Parts>>();

/** The matrix of a joint, the rotation that is in it, and the stretch before that. */
function partsOf(joint: number, transforms: Transforms): Parts {
  const known = knownParts.get(transforms) ?? new Map<number, Parts>();
  knownParts.set(transforms, known);
  let parts = known.get(joint);
  if (!parts) {
    const matrix = skinningMatrix(joint, transforms);
    const linear = matrix.slice(0, 3).map((line) => line.slice(0, 3));
    const rotation = rotationIn(linear);
    const stretch = multiply(transpose(rotation), linear);
    known.set(joint, (parts = { matrix, stretch, quaternion: quaternionOf(rotation) }));
  }
  return parts;
}

/** A row without its negative weights, which is divided by its sum if it had any. */
function positiveWeights(row: readonly Influence[]): Map<number, number> {
  const kept = row.filter(([, weight]) => weight > 0);
  const sum = kept.reduce((total, [, weight]) => total + weight, 0);
  const scale = row.some(([, weight]) => weight < 0) ? 1 / sum : 1;
  return new Map(kept.map(([joint, weight]) => [joint, weight * scale]));
}

/** The rotation nearest to a matrix: the mean of it and its inverse transpose, over and over. */
function rotationIn(matrix: Matrix): Matrix {
  let mean = matrix;
  for (let round = 0; round < 20; round++) {
    const upright = transpose(inverse(mean));
    mean = mean.map((row, r) => row.map((value, c) => (value + upright[r]![c]!) / 2));
  }
  return mean;
}

/**
 * The unit quaternion x, y, z, w of a rotation: the longest row of 4 q qᵀ, whose elements are sums
 * of those of the matrix.
 */
function quaternionOf(matrix: Matrix): Vector {
  const [a, b, c, d, e, f, g, h, i] = matrix.flat();
  const rows = [
    [1 + a! - e! - i!, b! + d!, c! + g!, h! - f!],
    [b! + d!, 1 - a! + e! - i!, f! + h!, c! - g!],
    [c! + g!, f! + h!, 1 - a! - e! + i!, d! - b!],
    [h! - f!, c! - g!, d! - b!, 1 + a! + e! + i!],
  ];
  return unit(
    rows.reduce((longest, row) => (dot(row, row) > dot(longest, longest) ? row : longest)),
  );
}

/** The matrix whose columns are the turned axes: v + 2 u × (u × v + w v). */
function turn([x, y, z, w]: Vector): Matrix {
  const u = [x!, y!, z!];
  const columns = [0, 1, 2].map((axis) => {
    const v = [0, 0, 0].map((_, i) => (i === axis ? 1 : 0));
    const inner = cross(u, v).map((value, i) => value + w! * v[i]!);
    return cross(u, inner).map((value, i) => v[i]! + 2 * value);
  });
  return transpose(columns);
}

function minus(a: Vector, b: Vector): number[] {
  return a.map((value, i) => value - b[i]!);
}

function dot(a: Vector, b: Vector): number {
  return a.reduce((sum, value, i) => sum + value * b[i]!, 0);
}

function cross([ax, ay, az]: Vector, [bx, by, bz]: Vector): number[] {
  return [ay! * bz! - az! * by!, az! * bx! - ax! * bz!, ax! * by! - ay! * bx!];
}
