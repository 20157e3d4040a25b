/**
 * For each tuple of `size` integers, returns the index of the first tuple that equals it. It hashes
 * with open addressing, so the time does not depend on how many tuples have elements in common.
 */
export function firstEqualTuples(values: Int32Array, size: number): Int32Array {
  const count = values.length / size;
  const mask = 2 ** Math.ceil(Math.log2(count * 2 + 1)) - 1;
  const slots = new Int32Array(mask + 1).fill(-1);
  const first = new Int32Array(count);
  for (let tuple = 0; tuple < count; tuple++) {
    let slot = hash(tuple) & mask;
    while (slots[slot] !== -1 && !isEqual(slots[slot]!, tuple)) slot = (slot + 1) & mask;
    if (slots[slot] === -1) slots[slot] = tuple;
    first[tuple] = slots[slot]!;
  }
  return first;

  /** FNV-1a over the integers, with a final mix because the table uses the low bits. */
  function hash(tuple: number): number {
    let state = 0x811c9dc5;
    for (let i = 0; i < size; i++) {
      state = Math.imul(state ^ values[tuple * size + i]!, 0x01000193);
      state ^= state >>> 15;
    }
    state = Math.imul(state ^ (state >>> 13), 0x5bd1e995);
    return state ^ (state >>> 15);
  }

  function isEqual(a: number, b: number): boolean {
    for (let i = 0; i < size; i++) {
      if (values[a * size + i] !== values[b * size + i]) return false;
    }
    return true;
  }
}

/** Does the same for floats, compared with `===`; none may be NaN. */
export function firstEqualFloats(values: Float32Array, size: number): Int32Array {
  const withoutMinusZero = values.map((value) => value + 0);
  return firstEqualTuples(new Int32Array(withoutMinusZero.buffer), size);
}
