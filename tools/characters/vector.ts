/** A point or a direction; the unit and the space are stated where it is used. */
export type Vector3 = readonly [x: number, y: number, z: number];

/** A texture coordinate with the origin at the lower left. */
export type Vector2 = readonly [u: number, v: number];

export function add(a: Vector3, b: Vector3): Vector3 {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}

export function subtract(a: Vector3, b: Vector3): Vector3 {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

export function scale(a: Vector3, factor: number): Vector3 {
  return [a[0] * factor, a[1] * factor, a[2] * factor];
}

export function cross(a: Vector3, b: Vector3): Vector3 {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

export function dot(a: Vector3, b: Vector3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function unit(a: Vector3): Vector3 {
  return scale(a, 1 / Math.hypot(...a));
}

/** Interpolates from a (0) to b (1). */
export function mix(a: Vector3, b: Vector3, t: number): Vector3 {
  return add(a, scale(subtract(b, a), t));
}

/** The mean of some points; throws if there are none. */
export function meanOf(points: readonly Vector3[]): Vector3 {
  if (points.length === 0) throw new Error('the mean of no points');
  const sum = [0, 0, 0] as [number, number, number];
  for (const point of points) {
    sum[0] += point[0];
    sum[1] += point[1];
    sum[2] += point[2];
  }
  return scale(sum, 1 / points.length);
}
