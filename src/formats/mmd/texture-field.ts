import type { MaterialParts } from '../../core/character-parts.ts';
import { extensionOf } from '../file-entry.ts';
import { fittedText } from './encode-name.ts';

export type Textures = Pick<MaterialParts, 'texture' | 'sphere'>;

export const textureFieldSize = 20;

/**
 * In "skin.bmp*shine.spa", the first is an image and the second a sphere map (`.sph` multiplies,
 * `.spa` adds); either may be missing.
 */
export function readTextures(field: string): Textures {
  const names = field.split('*').filter((name) => name.trim() !== '');
  const isSphere = (name: string): boolean => ['.sph', '.spa'].includes(extensionOf(name));
  const texture = names.find((name) => !isSphere(name));
  const sphere = names.find(isSphere);
  return {
    ...(texture === undefined ? {} : { texture }),
    ...(sphere === undefined
      ? {}
      : {
          sphere: {
            texture: sphere,
            blend: extensionOf(sphere) === '.spa' ? 'add' : 'multiply',
          },
        }),
  };
}

/**
 * Returns the text from which the same names are read; nothing if the field can't hold them,
 * because a name that is cut finds no file.
 */
export function textureField({ texture, sphere }: Textures): string | undefined {
  const text = [texture, sphere?.texture].filter((name) => name !== undefined).join('*');
  const found = readTextures(fittedText(text, textureFieldSize));
  const isSame =
    found.texture === texture &&
    found.sphere?.texture === sphere?.texture &&
    found.sphere?.blend === sphere?.blend;
  return isSame ? text : undefined;
}
