/**
 * Returns the name under which one of several things is saved: its own name, or `#` and its index
 * in the file where the name is not unique or looks like an index.
 */
export function keyAt(names: readonly string[], index: number, inFile = index): string {
  const name = names[index]!;
  const isClear = names.indexOf(name) === names.lastIndexOf(name) && !/^#\d+$/.test(name);
  return isClear ? name : `#${inFile}`;
}

/** Returns the index of the thing that is saved under a key, or -1. */
export function indexOfKey(names: readonly string[], key: string): number {
  if (!/^#\d+$/.test(key)) return names.indexOf(key);
  const index = Number(key.slice(1));
  return index < names.length ? index : -1;
}
