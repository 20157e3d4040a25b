import type { Vector2, Vector3 } from './vector.ts';

/**
 * Where lips and brows are. Each function is positive inside, zero on the outline, and grows about
 * evenly across it, so that faces can be cut along the outline.
 */

/** The lips are outlined in the texture's plane, in parts of its side. There the face lies on its
 * side: u goes down it, and v across it, from the middle of the mouth to its corners. */
const MOUTH_MIDDLE_V = 1 - 1058 / 2048;

/** Half the outline: v from the middle, then u of the edges of the upper and the lower lip. */
const LIPS: readonly (readonly [across: number, upper: number, lower: number])[] = [
  [0, 1836.5, 1893],
  [5, 1834.5, 1893],
  [10, 1832.5, 1892.5],
  [16, 1833.5, 1891.5],
  [22, 1835, 1890],
  [26, 1837.5, 1888],
  [30, 1841.5, 1885],
  [34, 1846, 1881],
  [38, 1852, 1874],
  [42, 1862, 1862],
].map(([across, upper, lower]) => [across! / 2048, upper! / 2048, lower! / 2048] as const);

/** @param coordinate a texture coordinate of MakeHuman's base mesh */
export function insideLips([u, v]: Vector2): number {
  const across = Math.abs(v - MOUTH_MIDDLE_V);
  const corner = LIPS.at(-1)!;
  if (across >= corner[0]) return corner[0] - across - Math.abs(u - corner[1]);
  const next = LIPS.findIndex(([end]) => end > across);
  const [start, end] = [LIPS[next - 1]!, LIPS[next]!];
  const along = (across - start[0]) / (end[0] - start[0]);
  const [upper, lower] = [1, 2].map((edge) => start[edge]! + (end[edge]! - start[edge]!) * along);
  return Math.min(u - upper!, lower! - u);
}

/**
 * The left brow from its inner to its outer end, seen from the front, in the decimeters of the base
 * mesh without targets: the middle line, and half of the width.
 */
const BROW: readonly (readonly [x: number, y: number, half: number])[] = [
  [0.1, 7.428, 0],
  [0.12, 7.432, 0.014],
  [0.16, 7.444, 0.022],
  [0.24, 7.471, 0.022],
  [0.33, 7.489, 0.017],
  [0.41, 7.484, 0.012],
  [0.48, 7.456, 0.006],
  [0.54, 7.418, 0],
];

/** Brows are on the front of the head only. */
const BROW_FRONT_Z = 0.9;

function browAt(x: number): readonly [y: number, half: number] {
  const next = BROW.findIndex(([end]) => end > x);
  const start = BROW[next - 1];
  if (start === undefined) return [BROW.at(next === 0 ? 0 : -1)![1], 0];
  const end = BROW[next]!;
  const along = (x - start[0]) / (end[0] - start[0]);
  return [start[1] + (end[1] - start[1]) * along, start[2] + (end[2] - start[2]) * along];
}

/** Farther from the middle line than this there is no brow. */
const BROW_REACH = 0.12;

/** A value so large that a cut from a point near a brow to one far away goes through the former. */
const FAR = 2;

/**
 * Positive above the middle line of the brows, along which faces are cut first, because brows are
 * not wider than faces.
 */
export function aboveBrows(point: Vector3): number {
  const [x, y, z] = [Math.abs(point[0]), point[1], point[2]];
  const [middle] = browAt(x);
  const isNear = z > BROW_FRONT_Z && x > BROW[0]![0] && x < BROW.at(-1)![0];
  return isNear && Math.abs(y - middle) < BROW_REACH ? y - middle : FAR;
}

/** @param point of the base mesh without targets */
export function insideBrows([x, y, z]: Vector3): number {
  if (z < BROW_FRONT_Z) return -1;
  const [middle, half] = browAt(Math.abs(x));
  const beyond = Math.max(BROW[0]![0] - Math.abs(x), Math.abs(x) - BROW.at(-1)![0], 0);
  return half - Math.abs(y - middle) - beyond;
}
