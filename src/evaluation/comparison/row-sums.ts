import { diagonal } from '../../core/bounds.ts';
import { normalizeSkin, type Skin } from '../../core/skin.ts';
import { poseVertices } from '../../skinning/pose-vertices.ts';
import type { Evaluation } from '../evaluation.ts';
import { type Difference, differenceOf, leastPart } from './difference.ts';

/** A sum of float32 weights that is this near to 1 is 1 but for rounding. */
const leastDeviation = 1e-6;

/** How the rows of a skin sum up. */
export interface RowSums {
  /** How many points have a row that does not sum to 1. */
  readonly count: number;
  /** The point whose row is farthest from 1, and its sum. */
  readonly worst: number;
  readonly worstSum: number;
}

/** Returns the rows that don't sum to 1, or null if there are none. */
export function rowSumsOf({ start, weights }: Skin): RowSums | null {
  let [count, worst, worstSum] = [0, 0, 1];
  for (let point = 0; point + 1 < start.length; point++) {
    let sum = 0;
    for (let i = start[point]!; i < start[point + 1]!; i++) sum += weights[i]!;
    if (Math.abs(sum - 1) <= leastDeviation) continue;
    count++;
    if (Math.abs(sum - 1) > Math.abs(worstSum - 1)) [worst, worstSum] = [point, sum];
  }
  return count > 0 ? { count, worst, worstSum } : null;
}

/**
 * Returns the part of what a method does that is due to rows that don't sum to 1: how far it moves
 * points from where it puts them by normalized rows, prepared by the same weights. It is null if all
 * rows sum to 1, or are normalized already.
 */
export function rowSumDifference(evaluation: Evaluation): Difference | null {
  const { state, rest, skin, method, palette, use } = evaluation;
  if (!rowSumsOf(skin)) return null;
  const { mesh, bounds } = state.character;
  const positions = new Float32Array(mesh.vertexCount * 3);
  const normalized = normalizedSkin(skin);
  poseVertices(method, mesh, rest, normalized, palette, use, { positions, normals: null });
  const shown = evaluation.vertices().positions;
  return differenceOf(shown, positions, mesh.pointCount, leastPart * diagonal(bounds));
}

function normalizedSkin(skin: Skin): Skin {
  let normalized = normalizedSkins.get(skin);
  if (!normalized) normalizedSkins.set(skin, (normalized = normalizeSkin(skin)));
  return normalized;
}

const normalizedSkins = new WeakMap<Skin, Skin>();
