import type { CharacterImage } from '../core/character.ts';

/** The picture, its first row at the bottom; nothing where the browser can't read it. Kept. */
export function decodeImage(image: CharacterImage): Promise<ImageBitmap | null> {
  let decoded = decodedImages.get(image);
  if (!decoded) decodedImages.set(image, (decoded = decode(image)));
  return decoded;
}

async function decode({ bytes }: CharacterImage): Promise<ImageBitmap | null> {
  try {
    return await createImageBitmap(new Blob([bytes as BlobPart]), {
      imageOrientation: 'flipY',
      premultiplyAlpha: 'none',
      colorSpaceConversion: 'none',
    });
  } catch {
    return null;
  }
}

const decodedImages = new WeakMap<CharacterImage, Promise<ImageBitmap | null>>();
