import { loadPart } from '../core/failure.ts';
import type { KernelId, SkinningMethod } from './method.ts';

export type LaterKernelId = Exclude<KernelId, 'linear-blend'>;

/** Loads the kernels that are not in the first script, each when it is needed. */
export const laterKernels: {
  readonly [Id in LaterKernelId]: () => Promise<SkinningMethod<Id>>;
} = {
  'joint-normals': async () => (await loadPart(import('./joint-normals.ts'))).jointNormals,
  rigid: async () => (await loadPart(import('./rigid.ts'))).rigid,
  'dual-quaternion': async () => (await loadPart(import('./dual-quaternion.ts'))).dualQuaternion,
  'centers-of-rotation': async () =>
    (await loadPart(import('./centers-of-rotation.ts'))).centersOfRotation,
  'delta-mush': async () => (await loadPart(import('./delta-mush.ts'))).deltaMush,
};
