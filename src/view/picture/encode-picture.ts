import { Failure } from '../../core/failure.ts';
import { canvasOf, type DrawOver } from './draw-over.ts';

export type PictureFormat = 'png' | 'jpeg' | 'webp';

export interface Picture {
  readonly width: number;
  readonly height: number;
  /** (width × height × 4) bytes of RGBA, with alpha not multiplied in, the top row first. */
  readonly pixels: Uint8ClampedArray<ArrayBuffer>;
}

/** The quality of formats with losses, from 0 to 1. */
export const lossyQuality = 0.92;

/**
 * Returns the bytes of a file. PNG keeps every pixel.
 *
 * @param drawOver draws what lies over the picture
 */
export async function encodePicture(
  picture: Picture,
  format: PictureFormat,
  drawOver?: DrawOver | null,
): Promise<Blob> {
  const { canvas } = canvasOf(picture, drawOver);
  const blob = await new Promise<Blob | null>((resolve) => {
    canvas.toBlob(resolve, `image/${format}`, lossyQuality);
  });
  if (!blob) throw new Failure('The browser could not make a file of the picture');
  // A browser that does not write a format gives a PNG in its place.
  if (blob.type !== `image/${format}`) {
    throw new Failure(`This browser writes no ${format.toUpperCase()} of this size; PNG it does`);
  }
  return blob;
}
