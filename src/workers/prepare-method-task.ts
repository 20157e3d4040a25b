import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';
import type { KernelId } from '../skinning/method.ts';
import { kernelById } from '../skinning/registry.ts';
import type { TaskProgress } from './tasks.ts';

/** A method, and the mesh and skin for which it prepares what it needs. */
export interface PrepareInput {
  readonly method: KernelId;
  readonly mesh: Mesh;
  readonly skin: Skin;
}

/** Computes what a skinning method prepares once for a skin, such as centers of rotation. */
export async function run(
  { method, mesh, skin }: PrepareInput,
  onProgress: TaskProgress,
): Promise<unknown> {
  const kernel = await kernelById(method).load();
  return kernel.prepare?.(mesh, skin, (part) => onProgress('', part));
}
