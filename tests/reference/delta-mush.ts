import { cross, minus } from './normals.ts';
import { type Matrix, multiply, transform, transpose, unit, type Vector } from './matrix.ts';

/** A surface whose points none coincide, before and after linear blend. */
export interface SkinnedSurface {
  readonly triangles: readonly (readonly number[])[];
  readonly rest: readonly Vector[];
  readonly restNormals: readonly Vector[];
  readonly skinned: readonly Vector[];
}

export interface MushedSurface {
  readonly positions: readonly Vector[];
  readonly normals: readonly Vector[];
}

/**
 * Mancewicz et al. 2014, in float64: both surfaces are smoothed by uniform Laplacian steps, and the
 * way from the smoothed surface back to the mesh is turned with the smoothed surface. Every point
 * must have faces that do not cancel.
 */
export function deltaMushed(surface: SkinnedSurface, steps = 15, lambda = 0.5): MushedSurface {
  const { triangles, rest, restNormals, skinned } = surface;
  const around = rest.map((_, point) => neighborsOf(triangles, point));
  const [from, to] = [rest, skinned].map((points) => smoothed(points, around, steps, lambda));
  const turns = rest.map((_, point) => turnOf(triangles, around[point]!, from!, to!, point));
  return {
    positions: rest.map((place, point) => {
      const detail = transform(turns[point]!, minus(place, from![point]!));
      return detail.map((value, axis) => to![point]![axis]! + value);
    }),
    normals: restNormals.map((normal, point) => transform(turns[point]!, normal)),
  };
}

/** The other ends of a point's edges; at an open boundary those of edges with one triangle. */
function neighborsOf(triangles: SkinnedSurface['triangles'], point: number): number[] {
  const others = triangles.filter((face) => face.includes(point)).flat();
  const counts = new Map<number, number>();
  for (const other of others) {
    if (other !== point) counts.set(other, (counts.get(other) ?? 0) + 1);
  }
  const open = [...counts.keys()].filter((other) => counts.get(other) === 1);
  return open.length > 0 ? open : [...counts.keys()];
}

function smoothed(
  points: readonly Vector[],
  around: readonly (readonly number[])[],
  steps: number,
  lambda: number,
): readonly Vector[] {
  if (steps === 0) return points;
  const once = points.map((point, index) =>
    point.map((value, axis) => {
      const others = around[index]!.map((other) => points[other]![axis]!);
      const mean = others.reduce((sum, other) => sum + other, 0) / others.length;
      return others.length === 0 ? value : value + lambda * (mean - value);
    }),
  );
  return smoothed(once, around, steps - 1, lambda);
}

/**
 * The rotation that takes the normal of one surface to that of the other, with the angle about it
 * that fits the edges best. In the complex plane of the tangents, that is the argument of
 * Σ conj(z) z′ over all edges z.
 */
function turnOf(
  triangles: SkinnedSurface['triangles'],
  around: readonly number[],
  from: readonly Vector[],
  to: readonly Vector[],
  point: number,
): Matrix {
  const [before, after] = [from, to].map((points) => frameOf(triangles, points, around, point));
  let [real, imaginary] = [0, 0];
  for (const other of around) {
    const [x, y] = transform(before!, minus(from[other]!, from[point]!));
    const [u, v] = transform(after!, minus(to[other]!, to[point]!));
    real += x! * u! + y! * v!;
    imaginary += x! * v! - y! * u!;
  }
  const angle = Math.atan2(imaginary, real);
  const about: Matrix = [
    [Math.cos(angle), -Math.sin(angle), 0],
    [Math.sin(angle), Math.cos(angle), 0],
    [0, 0, 1],
  ];
  return multiply(transpose(after!), multiply(about, before!));
}

/** Rows: two tangents, of which the first is along the first edge, and the normal. */
function frameOf(
  triangles: SkinnedSurface['triangles'],
  points: readonly Vector[],
  around: readonly number[],
  point: number,
): Matrix {
  const sum = [0, 0, 0];
  for (const face of triangles.filter((each) => each.includes(point))) {
    const [a, b, c] = face.map((corner) => points[corner]!);
    cross(minus(b!, a!), minus(c!, a!)).forEach((value, axis) => (sum[axis]! += value));
  }
  const normal = unit(sum);
  const bitangent = unit(cross(normal, minus(points[around[0]!]!, points[point]!)));
  return [cross(bitangent, normal), bitangent, normal];
}
