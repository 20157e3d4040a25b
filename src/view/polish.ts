import type { ActorLook } from '../document/actor-look.ts';

/** The highlight of clay: matte has none, and what is smoother has a smaller and brighter one. */
export function polishOf({ roughness }: ActorLook): { specular: number[]; shininess: number } {
  const polish = 1 - roughness;
  return {
    specular: [0, 0, 0].fill(0.35 * polish),
    shininess: polish === 0 ? 0 : 2 ** (2 + 6 * polish),
  };
}
