/** An sRGB color with channels from 0 to 1. */
export type Color = readonly [red: number, green: number, blue: number];

export function hex(code: number): Color {
  return [(code >> 16) / 255, ((code >> 8) & 255) / 255, (code & 255) / 255];
}

/** Interpolates from a (0) to b (1). */
export function blend(a: Color, b: Color, t: number): Color {
  const u = Math.min(1, Math.max(0, t));
  return [a[0] + (b[0] - a[0]) * u, a[1] + (b[1] - a[1]) * u, a[2] + (b[2] - a[2]) * u];
}

export function shade(color: Color, factor: number): Color {
  return [color[0] * factor, color[1] * factor, color[2] * factor];
}

/** Interpolates a row of colors that are evenly spaced from 0 to 1. */
export function ramp(colors: readonly Color[], t: number): Color {
  const at = Math.min(1, Math.max(0, t)) * (colors.length - 1);
  const first = Math.min(colors.length - 2, Math.floor(at));
  return blend(colors[first]!, colors[first + 1]!, at - first);
}

/** Returns a pseudorandom number from 0 to 1 for two integers, without a visible pattern. */
function hash(x: number, y: number): number {
  let h = Math.imul(x, 0x27d4eb2d) ^ Math.imul(y, 0x165667b1);
  h = Math.imul(h ^ (h >>> 15), 0x2c1b3c6d);
  h = Math.imul(h ^ (h >>> 12), 0x297a2d39);
  return ((h ^ (h >>> 15)) >>> 0) / 2 ** 32;
}

/** Smooth noise from 0 to 1, with one swell per unit. */
export function noise(x: number, y: number): number {
  const [column, row] = [Math.floor(x), Math.floor(y)];
  const ease = (t: number): number => t * t * (3 - 2 * t);
  const [u, v] = [ease(x - column), ease(y - row)];
  const top = hash(column, row) * (1 - u) + hash(column + 1, row) * u;
  const bottom = hash(column, row + 1) * (1 - u) + hash(column + 1, row + 1) * u;
  return top * (1 - v) + bottom * v;
}

/**
 * The distance to the nearest of scattered points, one per unit square: 0 at the point, about 1 far
 * away.
 */
export function dimples(x: number, y: number): number {
  let nearest = 2;
  for (let row = Math.floor(y) - 1; row <= Math.floor(y) + 1; row++) {
    for (let column = Math.floor(x) - 1; column <= Math.floor(x) + 1; column++) {
      const dx = column + 0.15 + 0.7 * hash(column, row) - x;
      const dy = row + 0.15 + 0.7 * hash(row + 7919, column) - y;
      nearest = Math.min(nearest, dx * dx + dy * dy);
    }
  }
  return Math.sqrt(nearest);
}
