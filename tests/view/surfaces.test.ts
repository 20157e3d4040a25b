import { describe, expect, it } from 'vitest';
import { buildCharacter } from '../../src/core/build-character.ts';
import type { CharacterImage } from '../../src/core/character.ts';
import type { MaterialColors, MaterialParts } from '../../src/core/character-parts.ts';
import { surfacesOf } from '../../src/view/surfaces.ts';

const colors: MaterialColors = {
  diffuse: [1, 0.5, 0],
  alpha: 1,
  specular: [1, 0, 0],
  shininess: 8,
  ambient: [0.5, 0, 0],
  shown: [1.1, 0.3, 0],
};

function surfaceOf(material: Omit<MaterialParts, 'name'>, images: readonly CharacterImage[] = []) {
  const { value } = buildCharacter({
    name: 'a',
    missing: [],
    mesh: {
      file: 'a',
      positions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0),
      cornerPoints: Uint32Array.of(0, 1, 2),
      materials: [{ name: 'm', ...material }],
      submeshes: [{ material: 'm', firstTriangle: 0 }],
    },
  });
  return surfacesOf({ ...value!, images })[0]!;
}

describe('surfaces', () => {
  it('have the color of the material, in linear light and for Sinew’s exposure', () => {
    const { albedo, specular, shininess } = surfaceOf({ colors });
    // 1.1 is beyond 1; 0.3 in sRGB is 0.0732 in linear light.
    expect(albedo).toEqual([0.6, expect.closeTo(0.6 * 0.0732, 4), 0]);
    expect(specular).toEqual([1, 0, 0]);
    expect(shininess).toBe(8);
  });

  it('show their inner side unless the material says otherwise', () => {
    expect(surfaceOf({ colors, twoSided: false }).twoSided).toBe(false);
    expect(surfaceOf({ colors, twoSided: true }).twoSided).toBe(true);
    expect(surfaceOf({}).twoSided).toBe(true);
  });

  it('have no highlight without an exponent, and none without colors', () => {
    expect(surfaceOf({ colors: { ...colors, shininess: 0 } }).specular).toEqual([0, 0, 0]);
    expect(surfaceOf({})).toMatchObject({ albedo: null, alpha: 1, specular: [0, 0, 0] });
  });

  it('clamp colors to the range of a display', () => {
    const wild = { ...colors, shown: [-4, 1e6, 0], specular: [-1, 2, 0] } as const;
    const { albedo, specular } = surfaceOf({ colors: wild });
    expect(albedo).toEqual([0, 0.6, 0]);
    expect(specular).toEqual([0, 1, 0]);
  });

  it('name the image of their texture', () => {
    const texture = 'tex\\Skin.bmp';
    const image = { name: 'tex/Skin.bmp', textures: [texture], bytes: new Uint8Array(0) };
    expect(surfaceOf({ texture }, [image]).texture).toBe('tex/Skin.bmp');
    expect(surfaceOf({ texture }).texture).toBeUndefined();
    expect(surfaceOf({}).texture).toBeUndefined();
  });
});
