/** GPUs flush subnormal numbers to zero; so do palettes, positions and normals here. */
export const smallestNormal = 1.2e-38;

export function flushSubnormal(value: number): number {
  return Math.abs(value) < smallestNormal ? 0 : value;
}
