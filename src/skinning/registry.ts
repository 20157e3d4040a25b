import { assert } from '../core/assert.ts';
import type { Character } from '../core/character.ts';
import { jointNormals } from './joint-normals.ts';
import { linearBlend } from './linear-blend.ts';
import type { MethodId, SkinningMethod } from './method.ts';
import { rigid } from './rigid.ts';

/** Every skinning method. */
export const methods: readonly SkinningMethod[] = [linearBlend, jointNormals, rigid];

/** The method that a character's own course asks for: CSE169's where the file has bindings. */
export function defaultMethod({ skin }: Pick<Character, 'skin'>): SkinningMethod {
  return skin.bindFromJoint ? jointNormals : linearBlend;
}

export function methodById(id: MethodId): SkinningMethod {
  const method = methods.find((candidate) => candidate.id === id);
  assert(method !== undefined, `a skinning method named ${id}`);
  return method;
}

export function isMethodId(id: string): id is MethodId {
  return methods.some((method) => method.id === id);
}
