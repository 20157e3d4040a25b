import { EvaluationPool } from '../../src/evaluation/evaluation-pool.ts';
import { Kernels } from '../../src/evaluation/kernels.ts';
import type { KernelId, SkinningMethod } from '../../src/skinning/method.ts';
import { poseLayers } from '../../src/posing/layers.ts';
import { kernels } from '../../src/skinning/registry.ts';

/** Every kernel of the registry, loaded. */
export const loadedKernels: readonly SkinningMethod[] = await Promise.all(
  kernels.map(({ load }) => load()),
);

export function loadedKernel(id: KernelId): SkinningMethod {
  return loadedKernels.find((kernel) => kernel.id === id)!;
}

/** All kernels and pose layers are loaded. */
export const allThere = new Kernels();
await Promise.all([
  ...kernels.map(({ id }) => allThere.load(id)),
  ...poseLayers.map((layer) => allThere.layer(layer).load()),
  allThere.recompute.load(),
  allThere.followed.load(),
]);

/** A pool whose kernels and pose layers are all loaded. */
export function fullPool(): EvaluationPool {
  return new EvaluationPool(allThere);
}
