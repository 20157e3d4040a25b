import { Failure } from '../core/failure.ts';
import type { ViewContent } from './render-view.ts';
import type { CaptureSize, Viewer } from './viewer.ts';

export type PictureFormat = 'png' | 'jpeg';

export interface Picture {
  readonly width: number;
  readonly height: number;
  /** (width × height × 4) bytes of RGBA, with alpha not multiplied in, the top row first. */
  readonly pixels: Uint8ClampedArray<ArrayBuffer>;
}

/** Captures exactly what the view shows, or the same view at another size or without what
 * surrounds the actors. */
export function capturePicture(
  viewer: Viewer,
  size: CaptureSize = viewer.size.value,
  showSurroundings = true,
  contents?: readonly ViewContent[],
): Picture {
  const { width, height } = size;
  return pictureFromGl(viewer.readPixels(size, showSurroundings, contents), width, height);
}

/**
 * GL returns the bottom row first, and colors that are multiplied by their alpha; they are divided
 * by it.
 */
function pictureFromGl(bottomUp: Uint8Array, width: number, height: number): Picture {
  const pixels = new Uint8ClampedArray(width * height * 4);
  const stride = width * 4;
  for (let row = 0; row < height; row++) {
    const source = (height - 1 - row) * stride;
    pixels.set(bottomUp.subarray(source, source + stride), row * stride);
  }
  for (let i = 0; i < pixels.length; i += 4) {
    const alpha = pixels[i + 3]!;
    if (alpha === 255 || alpha === 0) continue;
    for (let channel = i; channel < i + 3; channel++) {
      pixels[channel] = (pixels[channel]! * 255) / alpha;
    }
  }
  return { width, height, pixels };
}

/** Returns the bytes of a file. PNG keeps every pixel. */
export async function encodePicture(picture: Picture, format: PictureFormat): Promise<Blob> {
  const canvas = document.createElement('canvas');
  canvas.width = picture.width;
  canvas.height = picture.height;
  const context = canvas.getContext('2d');
  if (!context) throw new Failure('The browser has no room for a picture of this size');
  context.putImageData(new ImageData(picture.pixels, picture.width, picture.height), 0, 0);
  return new Promise((resolve, reject) => {
    canvas.toBlob(
      (blob) => {
        if (blob) resolve(blob);
        else reject(new Failure('The browser could not make a file of the picture'));
      },
      `image/${format}`,
      0.92,
    );
  });
}
