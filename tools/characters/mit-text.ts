import type { Vector3 } from './vector.ts';

/** A material of a `.mtl`: a color in sRGB, a highlight, an image; without a color it is clay. */
export interface Material {
  readonly name: string;
  readonly color?: Vector3;
  readonly gloss?: readonly [strength: number, exponent: number];
  readonly texture?: string;
}

/** Weights are stored as whole thousandths, so that a row can sum to exactly 1. */
const WEIGHT_STEPS = 1000;

/** Formats with at most a number of decimals, as short as possible: `.5`, and never `-0`. */
export function decimal(value: number, decimals: number): string {
  const rounded = Number(value.toFixed(decimals));
  return rounded === 0 ? '0' : String(rounded).replace(/^(-?)0\./, '$1.');
}

/**
 * Writes one line per joint, `tx ty tz parent`: the offset from the parent in file units (meters).
 */
export function skelText(offsets: readonly Vector3[], parents: readonly number[]): string {
  return offsets
    .map((offset, joint) => {
      const numbers = offset.map((value) => decimal(value, 5));
      return `${numbers.join(' ')} ${parents[joint]!}\n`;
    })
    .join('');
}

/** Writes a material library. */
export function mtlText(materials: readonly Material[]): string {
  const lines = materials.flatMap(({ name, color, gloss, texture }) => [
    `newmtl ${name}`,
    ...(color ? [`Kd ${color.join(' ')}`] : []),
    ...(gloss ? [`Ks ${gloss[0]} ${gloss[0]} ${gloss[0]}`, `Ns ${gloss[1]}`] : []),
    ...(texture === undefined ? [] : [`map_Kd ${texture}`]),
  ]);
  return `${lines.join('\n')}\n`;
}

/**
 * Writes one line per vertex with one weight for each joint except the first. Each weight has a
 * space after it, as in the course's own files. Rows contain integers that sum to `WEIGHT_STEPS`.
 */
export function attachText(rows: readonly (readonly number[])[]): string {
  return rows
    .map((row) => `${row.map((steps) => `${decimal(steps / WEIGHT_STEPS, 3)} `).join('')}\n`)
    .join('');
}

/**
 * Rounds weights to whole steps that sum to exactly `stepCount`, by the largest remainder method:
 * the steps left after rounding down go to the weights that lost most. Weights under one step are
 * dropped first.
 */
export function roundWeights(weights: readonly number[], stepCount = WEIGHT_STEPS): number[] {
  const kept = weights.map((weight) => (weight * stepCount < 1 ? 0 : weight));
  const sum = kept.reduce((total, weight) => total + weight, 0);
  if (sum <= 0) throw new Error('a vertex without weights');
  const exact = kept.map((weight) => (weight / sum) * stepCount);
  const steps = exact.map((value) => Math.floor(value + 1e-9));
  const missing = stepCount - steps.reduce((total, value) => total + value, 0);
  exact
    .map((value, index) => ({ index, lost: value - steps[index]! }))
    .sort((a, b) => b.lost - a.lost || a.index - b.index)
    .slice(0, missing)
    .forEach(({ index }) => (steps[index]! += 1));
  return steps;
}
