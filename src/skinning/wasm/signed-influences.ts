import type { Skin } from '../../core/skin.ts';
import { heaviestEntry } from '../heaviest-entry.ts';
import type { WasmRows } from '../method.ts';
import { bindFactors } from '../stretch.ts';

/** Entries of influences are uint16. */
const mostPairs = 65536;

/**
 * The influences of a skin as pairs with those of the largest weights. Negative weights count as 0.
 * Returns null if the skin stretches.
 *
 * @throws RangeError if there are too many pairs
 */
export function signedInfluences(skin: Skin): WasmRows | null {
  if (bindFactors(skin).stretch) return null;
  const { start, entries, weights } = skin;
  const indices = new Map<number, number>();
  const signed = new Uint16Array(entries.length);
  for (let point = 0; point + 1 < start.length; point++) {
    const pivot = heaviestEntry(skin, point);
    for (let i = start[point]!; i < start[point + 1]!; i++) {
      const pair = pivot * 65536 + entries[i]!;
      let index = indices.get(pair);
      if (index === undefined) indices.set(pair, (index = indices.size));
      signed[i] = index;
    }
  }
  if (indices.size > mostPairs) throw new RangeError(`${indices.size} pairs of palette entries`);
  const pairs = Uint16Array.from(
    [...indices.keys()].flatMap((pair) => [Math.floor(pair / 65536), pair % 65536]),
  );
  return {
    start,
    entries: signed,
    weights: weights.map((weight) => (weight > 0 ? weight : 0)),
    pairs,
  };
}
