import type { Weights } from './sweep.ts';

/**
 * Returns 0 up to `from`, 1 beyond `to`, and a smooth transition in between; `to` may be smaller
 * than `from`.
 */
export function smoothstep(from: number, to: number, value: number): number {
  const t = Math.min(1, Math.max(0, (value - from) / (to - from)));
  return t * t * (3 - 2 * t);
}

/**
 * A smooth curve through rows of numbers. The first number of each row is its place; places
 * increase. No value overshoots its neighbors': slopes are harmonic means, and zero at extremes
 * (Fritsch and Butland 1984).
 *
 * @returns the other numbers of a row at any place; beyond the ends they stay constant
 */
export function profile(rows: readonly (readonly number[])[]): (place: number) => number[] {
  const slopeOf = (row: number, column: number): number =>
    (rows[row + 1]![column]! - rows[row]![column]!) / (rows[row + 1]![0]! - rows[row]![0]!);
  const tangent = (row: number, column: number): number => {
    if (row === 0) return slopeOf(0, column);
    if (row === rows.length - 1) return slopeOf(row - 1, column);
    const [before, after] = [slopeOf(row - 1, column), slopeOf(row, column)];
    return before * after > 0 ? (2 * before * after) / (before + after) : 0;
  };
  return (place) => {
    let row = 0;
    while (row + 2 < rows.length && place > rows[row + 1]![0]!) row++;
    const [here, next] = [rows[row]!, rows[row + 1]!];
    const length = next[0]! - here[0]!;
    const u = Math.min(1, Math.max(0, (place - here[0]!) / length));
    return here.slice(1).map((value, index) => {
      const column = index + 1;
      const a = u * u * (3 - 2 * u);
      const b = u * (1 - u) * (1 - u) * length;
      const c = u * u * (u - 1) * length;
      return (
        value +
        (next[column]! - value) * a +
        tangent(row, column) * b +
        tangent(row + 1, column) * c
      );
    });
  };
}

/** The fraction of its radius that a rounded end has at a distance from the tip. */
export function roundedEnd(distance: number, length: number): number {
  const left = 1 - Math.min(1, Math.max(0, distance / length));
  return Math.sqrt(1 - left * left);
}

/** Places from 0 to 1, denser at both ends. */
export function places(count: number): number[] {
  return Array.from({ length: count }, (_, index) => {
    const t = index / (count - 1);
    return 0.5 * t + 0.25 * (1 - Math.cos(Math.PI * t));
  });
}

/**
 * Weights along a chain of joints. Each joint smoothly takes over from the one before it around the
 * place where it begins. A vertex where two such transitions overlap has three joints.
 *
 * @param chain joints in order, where each begins and half the length of its transition
 */
export function chainWeights(
  chain: readonly (readonly [joint: string, begin: number, half: number])[],
  place: number,
): Weights {
  let left = 1;
  const weights: [string, number][] = [];
  for (const [joint, begin, half] of chain.toReversed()) {
    const share = begin === -Infinity ? 1 : smoothstep(begin - half, begin + half, place);
    if (left * share > 0.0005) weights.push([joint, left * share]);
    left *= 1 - share;
  }
  return weights.toReversed();
}
