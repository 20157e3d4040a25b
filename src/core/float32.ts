/**
 * GPUs flush subnormal numbers to zero, so palettes, positions and normals here are flushed too.
 */
const smallestKept = Math.fround(1.2e-38);

export function flushSubnormal(value: number): number {
  return Math.abs(value) < smallestKept ? 0 : value;
}
