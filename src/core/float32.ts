/** GPUs flush subnormal numbers to zero; so do palettes, positions and normals here. */
const smallestKept = Math.fround(1.2e-38);

export function flushSubnormal(value: number): number {
  return Math.abs(value) < smallestKept ? 0 : value;
}
