import type { Vector2, Vector3 } from './vector.ts';

/**
 * A mesh as stored in an OBJ file, but with indices from zero. Each part becomes an `o` and a
 * `usemtl` with its name.
 */
export interface ObjMesh {
  readonly positions: readonly Vector3[];
  readonly textureCoordinates: readonly Vector2[];
  readonly parts: readonly ObjPart[];
}

export interface ObjPart {
  readonly name: string;
  /** The corners of each face, counterclockwise seen from outside: [position, texture]. */
  readonly faces: readonly (readonly (readonly [position: number, texture: number])[])[];
}

/** A material of a `.mtl`: a color in sRGB, a highlight, an image; without a color it is clay. */
export interface Material {
  readonly name: string;
  readonly color?: Vector3;
  readonly gloss?: readonly [strength: number, exponent: number];
  readonly texture?: string;
}

/** Weights are stored as whole ten-thousandths, so that a row can sum to exactly 1. */
const WEIGHT_STEPS = 10_000;

/** Formats with a fixed number of decimals, and never a negative zero. */
function fixed(value: number, decimals: number): string {
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? (0).toFixed(decimals) : text;
}

/**
 * Writes one line per joint, `tx ty tz parent`: the offset from the parent in file units (meters).
 */
export function skelText(offsets: readonly Vector3[], parents: readonly number[]): string {
  return offsets
    .map((offset, joint) => {
      const numbers = offset.map((value) => String(Number(fixed(value, 5))));
      return `${numbers.join(' ')} ${parents[joint]!}\n`;
    })
    .join('');
}

/**
 * Writes five decimals of a meter and four of the texture's side, which is finer than anyone can
 * see.
 */
export function objText(mesh: ObjMesh, library?: string): string {
  const lines = library === undefined ? [] : [`mtllib ${library}`];
  for (const position of mesh.positions) {
    lines.push(`v ${position.map((value) => fixed(value, 5)).join(' ')}`);
  }
  for (const coordinate of mesh.textureCoordinates) {
    lines.push(`vt ${coordinate.map((value) => String(Number(fixed(value, 4)))).join(' ')}`);
  }
  for (const part of mesh.parts) {
    lines.push(`o ${part.name}`, `usemtl ${part.name}`);
    for (const face of part.faces) {
      lines.push(`f ${face.map(([at, texture]) => `${at + 1}/${texture + 1}`).join(' ')}`);
    }
  }
  return `${lines.join('\n')}\n`;
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
  return rows.map((row) => `${row.map((steps) => `${steps / WEIGHT_STEPS} `).join('')}\n`).join('');
}

/**
 * Rounds weights to whole steps that sum to exactly `WEIGHT_STEPS`, by the largest remainder
 * method: the steps left after rounding down go to the weights that lost most. Weights under one
 * step are dropped first.
 */
export function roundWeights(weights: readonly number[]): number[] {
  const kept = weights.map((weight) => (weight * WEIGHT_STEPS < 1 ? 0 : weight));
  const sum = kept.reduce((total, weight) => total + weight, 0);
  if (sum <= 0) throw new Error('a vertex without weights');
  const exact = kept.map((weight) => (weight / sum) * WEIGHT_STEPS);
  // The small addition keeps 2999.9999999 from being rounded down to 2999.
  const steps = exact.map((value) => Math.floor(value + 1e-9));
  const missing = WEIGHT_STEPS - steps.reduce((total, value) => total + value, 0);
  exact
    .map((value, index) => ({ index, lost: value - steps[index]! }))
    .sort((a, b) => b.lost - a.lost || a.index - b.index)
    .slice(0, missing)
    .forEach(({ index }) => (steps[index]! += 1));
  return steps;
}
