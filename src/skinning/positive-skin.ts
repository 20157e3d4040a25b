import { type Influence, mapRows, type Skin } from '../core/skin.ts';

const { fround } = Math;

const known = new WeakMap<Skin, Skin>();

/**
 * Returns the skin without negative weights, for methods that average rotations: in a row that has
 * any they become 0, and the others are divided by their sum, in float32. A row without a positive
 * weight follows the first entry of the palette rigidly. Other rows stay as they are. The result is
 * computed once.
 */
export function positiveSkin(skin: Skin): Skin {
  let positive = known.get(skin);
  if (!positive) known.set(skin, (positive = mapRows(skin, positiveRow)));
  return positive;
}

function positiveRow(row: readonly Influence[]): readonly Influence[] {
  const sum = row.reduce((total, { weight }) => fround(total + Math.max(weight, 0)), 0);
  if (sum === 0) return [{ entry: 0, weight: 1 }];
  if (row.every(({ weight }) => weight >= 0)) return row;
  const scale = fround(1 / sum);
  return row.map(({ entry, weight }) => ({ entry, weight: fround(Math.max(weight, 0) * scale) }));
}
