import type { Mesh } from '../core/mesh.ts';

/**
 * (triangleCount) orders the triangles of a mesh so that each half of the list, each half of a half
 * and so on, down to runs of `runSize`, contains neighbors. Each part is split at the median along
 * its longest side.
 */
export function neighborOrder(mesh: Mesh, runSize: number): Uint32Array {
  const middles = middlesOf(mesh);
  const order = Uint32Array.from({ length: mesh.indices.length / 3 }, (_, triangle) => triangle);
  part(0, order.length);
  return order;

  function part(from: number, to: number): void {
    if (to - from <= runSize) return;
    const middle = (from + to) >> 1;
    const keys = middles[longestAxis(from, to)]!;
    select(order, keys, from, to, middle);
    part(from, middle);
    part(middle, to);
  }

  function longestAxis(from: number, to: number): number {
    const sizes = middles.map((keys) => {
      let [low, high] = [Infinity, -Infinity];
      for (let i = from; i < to; i++) {
        low = Math.min(low, keys[order[i]!]!);
        high = Math.max(high, keys[order[i]!]!);
      }
      return high - low;
    });
    return sizes.indexOf(Math.max(...sizes));
  }
}

/** Sums of the corners' coordinates, one array per axis; 0 for NaN. */
function middlesOf({ indices, positions }: Mesh): readonly Float32Array[] {
  return [0, 1, 2].map((axis) => {
    const sums = new Float32Array(indices.length / 3);
    for (let i = 0; i < indices.length; i++) {
      const triangle = Math.floor(i / 3);
      sums[triangle] = sums[triangle]! + positions[indices[i]! * 3 + axis]!;
    }
    return sums.map((sum) => (Number.isFinite(sum) ? sum : 0));
  });
}

/**
 * Reorders a run so that the element at `target` is the one that sorting by the keys would put
 * there, with no larger one before it and no smaller one after it (Hoare 1961, "Find").
 */
function select(
  order: Uint32Array,
  keys: Float32Array,
  from: number,
  to: number,
  target: number,
): void {
  let [first, last] = [from, to - 1];
  while (first < last) {
    const pivot = keys[order[(first + last) >> 1]!]!;
    let [low, high] = [first, last];
    while (low <= high) {
      while (keys[order[low]!]! < pivot) low++;
      while (keys[order[high]!]! > pivot) high--;
      if (low > high) break;
      const swapped = order[low]!;
      order[low++] = order[high]!;
      order[high--] = swapped;
    }
    if (target <= high) last = high;
    else if (target >= low) first = low;
    else return;
  }
}
