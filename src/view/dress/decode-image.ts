import type { CharacterImage } from '../../core/character.ts';
import { Failure, loadPart } from '../../core/failure.ts';
import { extensionOf } from '../../formats/file-entry.ts';
import { DecodedImages, type Picture } from './decoded-images.ts';

async function decode({ name, bytes }: CharacterImage): Promise<Picture | string> {
  try {
    if (extensionOf(name) === '.tga') {
      const { decodeTga } = await loadPart(import('../../formats/image/tga.ts'));
      const image = decodeTga(bytes);
      return typeof image === 'string' ? image : new ImageData(image.pixels, image.width);
    }
    return await createImageBitmap(new Blob([bytes as BlobPart]), {
      imageOrientation: 'flipY',
      premultiplyAlpha: 'none',
      colorSpaceConversion: 'none',
    });
  } catch (error) {
    if (error instanceof Failure) return error.message;
    return 'a picture that this browser can’t read';
  }
}

/**
 * The decoded images of the page, limited to the bytes of sixteen pictures of 1,024 × 1,024 pixels.
 */
export const decodedImages = new DecodedImages(decode, 64 * 1024 * 1024);
