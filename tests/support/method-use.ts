import type { Mesh } from '../../src/core/mesh.ts';
import type { Skin } from '../../src/core/skin.ts';
import {
  type MethodSettings,
  type MethodUse,
  plainSettings,
  type SkinningMethod,
} from '../../src/skinning/method.ts';

/** Preparing takes long for a large mesh, so it is done once for each method, mesh and skin. */
const prepared = new WeakMap<Skin, Map<SkinningMethod, { mesh: Mesh; extra: unknown }>>();

function extraOf(method: SkinningMethod, mesh: Mesh, skin: Skin): unknown {
  let known = prepared.get(skin);
  if (!known)
    prepared.set(skin, (known = new Map<SkinningMethod, { mesh: Mesh; extra: unknown }>()));
  let found = known.get(method);
  if (found?.mesh !== mesh) {
    found = { mesh, extra: method.prepare?.(mesh, skin, () => undefined) };
    known.set(method, found);
  }
  return found.extra;
}

/** What a method deforms a mesh with, prepared in place. */
export function useOf(
  method: SkinningMethod,
  mesh: Mesh,
  skin: Skin,
  settings: MethodSettings = plainSettings,
): MethodUse {
  return { extra: extraOf(method, mesh, skin), settings };
}
