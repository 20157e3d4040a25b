import { describe, expect, it } from 'vitest';
import { buildCharacter } from '../../src/core/build-character.ts';
import type { MaterialColours, MaterialParts } from '../../src/core/character-parts.ts';
import { surfacesOf } from '../../src/view/surfaces.ts';

const colours: MaterialColours = {
  diffuse: [1, 0.5, 0],
  alpha: 1,
  specular: [1, 0, 0],
  shininess: 8,
  ambient: [0.5, 0, 0],
};

function surfaceOf(material: Omit<MaterialParts, 'name'>) {
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
  return surfacesOf(value!)[0]!;
}

describe('surfaces', () => {
  it('have the colour of MikuMikuDance’s full light, in linear light and for our exposure', () => {
    const { albedo, specular, shininess } = surfaceOf({ colours });
    // 0.5 + 0.604 is past 1; 0.604 / 2 in sRGB is 0.0742 in linear light.
    expect(albedo).toEqual([0.6, expect.closeTo(0.6 * 0.0742, 4), 0]);
    expect(specular).toEqual([1, 0, 0]);
    expect(shininess).toBe(8);
  });

  it('show their inner side where they are seen through, or where nothing is said of colours', () => {
    expect(surfaceOf({ colours }).twoSided).toBe(false);
    expect(surfaceOf({ colours: { ...colours, alpha: 0.99 } }).twoSided).toBe(true);
    expect(surfaceOf({}).twoSided).toBe(true);
  });

  it('have no highlight without an exponent, and none without colours', () => {
    expect(surfaceOf({ colours: { ...colours, shininess: 0 } }).specular).toEqual([0, 0, 0]);
    expect(surfaceOf({})).toMatchObject({ albedo: null, alpha: 1, specular: [0, 0, 0] });
  });

  it('take colours past what a display has as its ends', () => {
    const wild = { ...colours, diffuse: [-4, 1e6, 0], specular: [-1, 2, 0] } as const;
    const { albedo, specular } = surfaceOf({ colours: wild });
    expect(albedo).toEqual([0, 0.6, 0]);
    expect(specular).toEqual([0, 1, 0]);
  });

  it('name the image without its folders', () => {
    expect(surfaceOf({ texture: 'tex\\Skin.bmp' }).texture).toBe('Skin.bmp');
    expect(surfaceOf({}).texture).toBeUndefined();
  });
});
