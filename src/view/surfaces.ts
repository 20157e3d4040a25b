import type { Character } from '../core/character.ts';
import type { Color } from '../core/character-parts.ts';
import type { Submesh } from '../core/mesh.ts';
import { linearChannel } from './theme.ts';

/** A run of triangles and how its material shades it, with colors in linear light. */
export interface Surface {
  readonly submesh: Submesh;
  /** The matte color, or null if the file has none. */
  readonly albedo: readonly number[] | null;
  readonly alpha: number;
  /** Whether the inner side is visible too. */
  readonly twoSided: boolean;
  /** The color of the highlight. */
  readonly specular: readonly number[];
  /** The exponent of the highlight. */
  readonly shininess: number;
  /** The texture's name in the character's images. */
  readonly texture: string | undefined;
}

/** With this factor, a surface that faces the key light shows approximately its own color. */
const keyExposure = 0.6;
const black: Color = [0, 0, 0];

/**
 * Returns the surfaces of a mesh in the order of the file. The matte color is what the material
 * shows in full light, at most 1, because the studio's lights do the rest. Without an exponent
 * there is no highlight, because it would cover everything.
 */
export function surfacesOf({ mesh, materials, images }: Character): readonly Surface[] {
  return mesh.submeshes.map((submesh) => {
    const material = materials.find(({ name }) => name === submesh.material);
    const { colors, texture } = material ?? {};
    const shininess = colors?.shininess ?? 0;
    return {
      submesh,
      albedo: colors?.shown.map((channel) => keyExposure * linearOf(channel)) ?? null,
      alpha: colors?.alpha ?? 1,
      twoSided: material?.twoSided ?? true,
      specular: ((shininess > 0 && colors?.specular) || black).map(linearOf),
      shininess,
      texture: images.find(({ textures }) => textures.some((each) => each === texture))?.name,
    };
  });
}

function linearOf(encoded: number): number {
  return linearChannel(Math.min(Math.max(encoded, 0), 1));
}
