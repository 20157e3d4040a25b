/** An axis-aligned box. While it contains nothing, `min` is greater than `max`. */
export interface Bounds {
  readonly min: Float64Array;
  readonly max: Float64Array;
}

export function emptyBounds(): Bounds {
  return { min: new Float64Array(3).fill(Infinity), max: new Float64Array(3).fill(-Infinity) };
}

export function isEmpty(bounds: Bounds): boolean {
  return bounds.min[0]! > bounds.max[0]!;
}

/** Extends the box to include `count` positions (xyz triples). */
export function includePositions(
  bounds: Bounds,
  positions: ArrayLike<number>,
  count: number,
): void {
  for (let i = 0; i < count * 3; i++) {
    const axis = i % 3;
    const value = positions[i]!;
    if (value < bounds.min[axis]!) bounds.min[axis] = value;
    if (value > bounds.max[axis]!) bounds.max[axis] = value;
  }
}

/** The length that tolerances and display sizes are relative to; 0 for an empty box. */
export function diagonal(bounds: Bounds): number {
  return isEmpty(bounds) ? 0 : Math.hypot(...extents(bounds));
}

export function extents(bounds: Bounds): [number, number, number] {
  const { min, max } = bounds;
  return [max[0]! - min[0]!, max[1]! - min[1]!, max[2]! - min[2]!];
}
