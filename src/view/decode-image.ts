import type { CharacterImage } from '../core/character.ts';
import { Failure, loadPart } from '../core/failure.ts';
import { extensionOf } from '../formats/file-entry.ts';

/** The picture, its first row at the bottom, or why it can't be shown. Kept. */
export function decodeImage(image: CharacterImage): Promise<ImageBitmap | ImageData | string> {
  let decoded = decodedImages.get(image);
  if (!decoded) decodedImages.set(image, (decoded = decode(image)));
  return decoded;
}

async function decode({ name, bytes }: CharacterImage): Promise<ImageBitmap | ImageData | string> {
  try {
    if (extensionOf(name) === '.tga') {
      const { decodeTga } = await loadPart(import('../formats/image/tga.ts'));
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

const decodedImages = new WeakMap<CharacterImage, ReturnType<typeof decode>>();
