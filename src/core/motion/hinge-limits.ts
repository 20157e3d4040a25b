const turn = 2 * Math.PI;

/** How far beyond a limit an angle may be, in radians, to count as within it. */
const slack = 1e-9;

/**
 * Puts three angles of hinges at right angles within their limits. If they are outside, equivalent
 * ones that are within are taken: other full turns of each, or those of (a + π, π − b, c + π), which
 * is the same rotation. If there are none, each angle goes to its nearest limit.
 */
export function keepWithin(angles: Float64Array, minima: Float64Array, maxima: Float64Array): void {
  const [a, b, c] = [angles[0]!, angles[1]!, angles[2]!];
  const isFitting =
    fit(a, b, c, angles, minima, maxima) ||
    fit(a + Math.PI, Math.PI - b, c + Math.PI, angles, minima, maxima);
  if (isFitting) return;
  angles[0] = clamped(a, minima[0]!, maxima[0]!);
  angles[1] = clamped(b, minima[1]!, maxima[1]!);
  angles[2] = clamped(c, minima[2]!, maxima[2]!);
}

function fit(
  a: number,
  b: number,
  c: number,
  angles: Float64Array,
  minima: Float64Array,
  maxima: Float64Array,
): boolean {
  angles[0] = turnedInto(a, minima[0]!, maxima[0]!);
  angles[1] = turnedInto(b, minima[1]!, maxima[1]!);
  angles[2] = turnedInto(c, minima[2]!, maxima[2]!);
  let isFitting = true;
  for (let i = 0; i < 3; i++) {
    const within = clamped(angles[i]!, minima[i]!, maxima[i]!);
    isFitting &&= Math.abs(within - angles[i]!) <= slack;
    angles[i] = within;
  }
  return isFitting;
}

/** The angle after the fewest full turns that bring it to the inner side of the limit it is beyond. */
function turnedInto(angle: number, minimum: number, maximum: number): number {
  if (angle > maximum + slack) return angle - turn * Math.ceil((angle - slack - maximum) / turn);
  if (angle < minimum - slack) return angle + turn * Math.ceil((minimum - slack - angle) / turn);
  return angle;
}

function clamped(angle: number, minimum: number, maximum: number): number {
  return Math.min(Math.max(angle, minimum), maximum);
}
