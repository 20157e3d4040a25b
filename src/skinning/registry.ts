import { assert } from '../core/assert.ts';
import type { Character } from '../core/character.ts';
import type { NormalsId } from '../core/skin.ts';
import { jointNormals } from './joint-normals.ts';
import { linearBlend } from './linear-blend.ts';
import type { KernelId, MethodId, SkinningMethod } from './method.ts';
import { rigid } from './rigid.ts';

/** Every kernel: a method with a way of normals. */
export const kernels: readonly SkinningMethod[] = [linearBlend, jointNormals, rigid];

/** Every skinning method, as people choose it. */
export const methods: readonly SkinningMethod<MethodId>[] = [linearBlend, rigid];

/** Every way in which normals follow, as people choose it. */
export const normalWays: readonly { readonly id: NormalsId; readonly label: string }[] = [
  { id: 'blended', label: 'By the blended matrix' },
  { id: 'joints', label: 'By each joint (CSE169)' },
];

/** How a character is deformed: a method and a way of normals. */
export interface Deformation {
  readonly method: MethodId;
  readonly normals: NormalsId;
}

/** As the programs of the character's own format deform it. */
export function defaultDeformation({ skin }: Pick<Character, 'skin'>): Deformation {
  return { method: 'linear-blend', normals: skin.normals };
}

/** A rigid part has one matrix, by which both ways turn its normals alike. */
export function kernelOf({ method, normals }: Deformation): SkinningMethod {
  if (method === 'linear-blend' && normals === 'joints') return jointNormals;
  return kernelById(method);
}

export function deformationOf(id: KernelId): Deformation {
  return id === 'joint-normals'
    ? { method: 'linear-blend', normals: 'joints' }
    : { method: id, normals: 'blended' };
}

export function kernelById(id: KernelId): SkinningMethod {
  const kernel = kernels.find((candidate) => candidate.id === id);
  assert(kernel !== undefined, `a skinning kernel named ${id}`);
  return kernel;
}

export function isKernelId(id: string): id is KernelId {
  return kernels.some((kernel) => kernel.id === id);
}
