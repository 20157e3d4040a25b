import { assert } from '../core/assert.ts';
import { linearBlend } from './linear-blend.ts';
import type { MethodId, SkinningMethod } from './method.ts';
import { rigid } from './rigid.ts';

/** Every skinning method, the default first. */
export const methods: readonly SkinningMethod[] = [linearBlend, rigid];

export function methodById(id: MethodId): SkinningMethod {
  const method = methods.find((candidate) => candidate.id === id);
  assert(method !== undefined, `a skinning method named ${id}`);
  return method;
}

export function isMethodId(id: string): id is MethodId {
  return methods.some((method) => method.id === id);
}
