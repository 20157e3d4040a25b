import type { Vector } from './matrix.ts';

/** How faces count at a point, by the id of the way of normals. */
export const faceWeights: Readonly<
  Record<string, (corner: Vector, next: Vector, last: Vector) => number>
> = {
  faces: () => 1,
  area: (a, b, c) => length(cross(minus(b, a), minus(c, a))) / 2,
  // The law of cosines, with all three sides.
  angle(a, b, c) {
    const [p, q, r] = [length(minus(b, a)), length(minus(c, a)), length(minus(c, b))];
    return Math.acos(Math.max(-1, Math.min(1, (p * p + q * q - r * r) / (2 * p * q))));
  },
};

/**
 * The handout, part 5.1, "the average normal of the neighboring faces", in float64: the weighted mean
 * of the unit normals of the faces around a place, point by point and without any table.
 *
 * @param faces three places each, counterclockwise
 * @param isHere whether a corner belongs to the point
 * @returns the mean, not yet of unit length
 */
export function meanNormal(
  faces: readonly (readonly [number, number, number])[],
  places: readonly Vector[],
  isHere: (corner: number) => boolean,
  way: string,
): number[] {
  const weigh = faceWeights[way]!;
  const sum = [0, 0, 0];
  let total = 0;
  for (const face of faces) {
    for (let i = 0; i < 3; i++) {
      if (!isHere(face[i]!)) continue;
      const [a, b, c] = [0, 1, 2].map((k) => places[face[(i + k) % 3]!]!) as [
        Vector,
        Vector,
        Vector,
      ];
      const across = cross(minus(b, a), minus(c, a));
      const size = length(across);
      if (size === 0) continue;
      const weight = weigh(a, b, c);
      total += weight;
      across.forEach((value, axis) => (sum[axis]! += (weight * value) / size));
    }
  }
  return sum.map((value) => (total === 0 ? 0 : value / total));
}

export function minus(a: Vector, b: Vector): number[] {
  return a.map((value, axis) => value - b[axis]!);
}

export function cross([ax, ay, az]: Vector, [bx, by, bz]: Vector): number[] {
  return [ay! * bz! - az! * by!, az! * bx! - ax! * bz!, ax! * by! - ay! * bx!];
}

function length(vector: Vector): number {
  return Math.hypot(...vector);
}
