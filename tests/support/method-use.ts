import type { Mesh } from '../../src/core/mesh.ts';
import type { Skin } from '../../src/core/skin.ts';
import {
  type MethodSettings,
  type MethodUse,
  plainSettings,
  type SkinningMethod,
} from '../../src/skinning/method.ts';

/** What a method deforms a mesh with, prepared in place. */
export function useOf(
  method: SkinningMethod,
  mesh: Mesh,
  skin: Skin,
  settings: MethodSettings = plainSettings,
): MethodUse {
  return { extra: method.prepare?.(mesh, skin, () => undefined), settings };
}
