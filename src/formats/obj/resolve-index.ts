/**
 * Converts a one-based index, or a negative one that counts back from this line, to zero-based; -1
 * if it does not exist.
 */
export function resolveIndex(index: number, count: number): number {
  const resolved = index < 0 ? count + index : index - 1;
  return index !== 0 && resolved >= 0 && resolved < count ? resolved : -1;
}
