import { Failure } from '../../core/failure.ts';
import type { Picture } from './encode-picture.ts';

/** Draws over a finished picture. */
export type DrawOver = (context: CanvasRenderingContext2D) => void;

/** Returns a canvas with a picture, and what is drawn over it. */
export function canvasOf(
  { width, height, pixels }: Picture,
  drawOver?: DrawOver | null,
): { readonly canvas: HTMLCanvasElement; readonly context: CanvasRenderingContext2D } {
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext('2d', { willReadFrequently: true });
  const noRoom = `This browser has no room for a picture of ${width} × ${height} pixels`;
  if (!context) throw new Failure(noRoom);
  context.putImageData(new ImageData(pixels, width, height), 0, 0);
  drawOver?.(context);
  return { canvas, context };
}

/** Returns the picture with what is drawn over it; the very same one if nothing is. */
export function drawnOver(picture: Picture, drawOver: DrawOver | null | undefined): Picture {
  if (!drawOver) return picture;
  const { width, height } = picture;
  const { data } = canvasOf(picture, drawOver).context.getImageData(0, 0, width, height);
  return { width, height, pixels: data };
}
