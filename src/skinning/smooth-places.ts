import type { SurfaceRings } from './surface-rings.ts';

/**
 * Smooths a surface by steps of the uniform Laplacian: in each, every place moves by `lambda` of
 * the way to the mean of its neighbors, p ← p + λ (mean − p), all at once. Places without
 * neighbors stay.
 *
 * @param places (placeCount × 3) unchanged
 * @param work two buffers of the same length, which are overwritten
 * @returns the buffer that holds the result: one of `work`
 */
export function smoothPlaces(
  rings: SurfaceRings,
  places: Float64Array,
  steps: number,
  lambda: number,
  work: readonly [Float64Array, Float64Array],
): Float64Array {
  let from = work[0];
  let to = work[1];
  from.set(places);
  for (let step = 0; step < steps; step++) {
    smoothOnce(rings, from, lambda, to);
    const done = to;
    to = from;
    from = done;
  }
  return from;
}

function smoothOnce(
  { placeCount, ringStart, ring }: SurfaceRings,
  from: Float64Array,
  lambda: number,
  to: Float64Array,
): void {
  let i = 0;
  for (let place = 0; place < placeCount; place++) {
    const first = i;
    const end = ringStart[place + 1]!;
    let x = 0;
    let y = 0;
    let z = 0;
    for (; i < end; i++) {
      const at = ring[i]! * 3;
      x += from[at]!;
      y += from[at + 1]!;
      z += from[at + 2]!;
    }
    const at = place * 3;
    const stays = end === first ? 1 : 1 - lambda;
    const share = end === first ? 0 : lambda / (end - first);
    to[at] = stays * from[at]! + share * x;
    to[at + 1] = stays * from[at + 1]! + share * y;
    to[at + 2] = stays * from[at + 2]! + share * z;
  }
}
