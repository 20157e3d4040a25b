import { add, cross, dot, scale, subtract, unit, type Vector2, type Vector3 } from '../vector.ts';

/** Joints by name with the weight of each; the weights of a vertex sum to 1. */
export type Weights = readonly (readonly [joint: string, weight: number])[];

/**
 * An ellipse of the surface. Lengths are in model units, in the space in which the insect is bound.
 */
export interface Station {
  readonly center: Vector3;
  /** Orthogonal unit vectors; side × up is the direction of the sweep. */
  readonly side: Vector3;
  readonly up: Vector3;
  /** Half the width (along `side`) and half the height (along `up`). */
  readonly width: number;
  readonly height: number;
  /** The height below the center divided by the height above it; 1 if absent. */
  readonly belly?: number;
  /** The distance along the part, for the texture. */
  readonly along: number;
  readonly weights: Weights;
}

/** A closed surface, counterclockwise seen from outside, without duplicate vertices. */
export interface Surface {
  readonly positions: readonly Vector3[];
  readonly textureCoordinates: readonly Vector2[];
  readonly weights: readonly Weights[];
  readonly triangles: readonly (readonly [number, number, number])[];
}

/** The texture coordinate for a station and an angle, in radians from `side` toward `up`. */
export type Place = (along: number, angle: number) => Vector2;

/**
 * Makes a surface through ellipses. The first and the last station are its poles, which are points
 * instead of rings.
 */
export function sweep(stations: readonly Station[], segments: number, place: Place): Surface {
  const positions: Vector3[] = [];
  const textureCoordinates: Vector2[] = [];
  const weights: Weights[] = [];
  const put = (position: Vector3, station: Station, angle: number): number => {
    textureCoordinates.push(place(station.along, angle));
    weights.push(station.weights);
    return positions.push(position) - 1;
  };
  const first = stations[0]!;
  const last = stations.at(-1)!;
  const rings = stations.slice(1, -1).map((station) =>
    Array.from({ length: segments }, (_, segment) => {
      const angle = (segment / segments) * 2 * Math.PI;
      const rise = Math.sin(angle) * station.height;
      const height = rise < 0 ? rise * (station.belly ?? 1) : rise;
      const across = scale(station.side, Math.cos(angle) * station.width);
      const offset = add(across, scale(station.up, height));
      return put(add(station.center, offset), station, angle);
    }),
  );
  const poles = [put(first.center, first, Math.PI / 2), put(last.center, last, Math.PI / 2)];
  const triangles: [number, number, number][] = [];
  for (let segment = 0; segment < segments; segment++) {
    const next = (segment + 1) % segments;
    triangles.push([poles[0]!, rings[0]![next]!, rings[0]![segment]!]);
    for (let ring = 0; ring + 1 < rings.length; ring++) {
      const [here, there] = [rings[ring]!, rings[ring + 1]!];
      triangles.push([here[segment]!, here[next]!, there[next]!]);
      triangles.push([here[segment]!, there[next]!, there[segment]!]);
    }
    triangles.push([poles[1]!, rings.at(-1)![segment]!, rings.at(-1)![next]!]);
  }
  return { positions, textureCoordinates, weights, triangles };
}

/** Frames along a curve that rotate no more than the curve itself. */
export function framesAlong(
  points: readonly Vector3[],
  firstUp: Vector3,
): { readonly side: Vector3; readonly up: Vector3 }[] {
  let up = firstUp;
  return points.map((_, index) => {
    const before = points[Math.max(0, index - 1)]!;
    const after = points[Math.min(points.length - 1, index + 1)]!;
    const forward = unit(subtract(after, before));
    up = unit(subtract(up, scale(forward, dot(up, forward))));
    return { side: cross(up, forward), up };
  });
}

/** Mirrors a surface in the plane x = 0, with the joints of the other side. */
export function mirrored(surface: Surface): Surface {
  return {
    positions: surface.positions.map(([x, y, z]): Vector3 => [-x, y, z]),
    textureCoordinates: surface.textureCoordinates,
    weights: surface.weights.map((row) =>
      row.map(([joint, weight]) => [joint.replace('_l', '_r'), weight] as const),
    ),
    triangles: surface.triangles.map(([a, b, c]) => [a, c, b] as const),
  };
}

/** Joins several surfaces into one. */
export function joined(surfaces: readonly Surface[]): Surface {
  let start = 0;
  const triangles = surfaces.flatMap((surface) => {
    const shift = start;
    start += surface.positions.length;
    return surface.triangles.map(([a, b, c]) => [a + shift, b + shift, c + shift] as const);
  });
  return {
    positions: surfaces.flatMap(({ positions }) => positions),
    textureCoordinates: surfaces.flatMap(({ textureCoordinates }) => textureCoordinates),
    weights: surfaces.flatMap(({ weights }) => weights),
    triangles,
  };
}
