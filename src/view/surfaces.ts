import type { Character } from '../core/character.ts';
import type { Colour } from '../core/character-parts.ts';
import type { Submesh } from '../core/mesh.ts';
import { baseName } from '../formats/file-entry.ts';
import { linearChannel } from './theme.ts';

/** A run of triangles and how its material shades it; colours in linear light. */
export interface Surface {
  readonly submesh: Submesh;
  /** The matte colour; null where the file has none. */
  readonly albedo: readonly number[] | null;
  readonly alpha: number;
  /** Whether the inner side shows too. */
  readonly twoSided: boolean;
  /** Of the highlight. */
  readonly specular: readonly number[];
  /** Exponent of the highlight. */
  readonly shininess: number;
  /** As the character's images have it. */
  readonly texture: string | undefined;
}

/** What MikuMikuDance's light has of each channel as the program starts. */
const programLight = 154 / 255;
/** With this of its colour a surface that faces the key light shows about the colour itself. */
const keyExposure = 0.6;
const black: Colour = [0, 0, 0];

/**
 * The surfaces of a mesh, in the order of the file. The matte colour is what MikuMikuDance shows in full
 * light, ambient + light · diffuse, at most 1: the studio's lights do the rest. Without an exponent
 * there is no highlight, which else would cover everything. Models for that program have linings close
 * below their surfaces and rely on it to leave out the inner sides of all that is opaque.
 */
export function surfacesOf({ mesh, materials }: Character): readonly Surface[] {
  return mesh.submeshes.map((submesh) => {
    const material = materials.find(({ name }) => name === submesh.material);
    const { colours, texture } = material ?? {};
    const lit = colours?.ambient.map((ambient, i) => ambient + programLight * colours.diffuse[i]!);
    const shininess = colours?.shininess ?? 0;
    return {
      submesh,
      albedo: lit?.map((channel) => keyExposure * linearOf(channel)) ?? null,
      alpha: colours?.alpha ?? 1,
      twoSided: !colours || colours.alpha < 1,
      specular: ((shininess > 0 && colours?.specular) || black).map(linearOf),
      shininess,
      texture: texture === undefined ? undefined : baseName(texture),
    };
  });
}

function linearOf(encoded: number): number {
  return linearChannel(Math.min(Math.max(encoded, 0), 1));
}
