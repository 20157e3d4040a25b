import type { CaptureSize } from '../viewer.ts';
import type { PictureFormat } from './encode-picture.ts';

export type PictureSizeId = 'view' | '1080p' | '4k' | 'a4' | 'free';

/** How pictures are saved. */
export interface PictureSettings {
  readonly format: PictureFormat;
  readonly size: PictureSizeId;
  /** The size in pixels where `size` is free; a shot's aspect decides over the height. */
  readonly width: number;
  readonly height: number;
  /** Samples on each side of a pixel. */
  readonly samples: number;
  /** Whether floor and backdrop are drawn; without them a picture is transparent, but no JPEG. */
  readonly background: boolean;
}

export const plainSettings: PictureSettings = {
  format: 'png',
  size: 'view',
  width: 1920,
  height: 1080,
  samples: 1,
  background: true,
};

/** A sheet of A4 in pixels at 300 dpi: 210 × 297 mm. */
const sheet = { short: (210 / 25.4) * 300, long: (297 / 25.4) * 300 };

/**
 * Returns the size of one view's picture in pixels.
 *
 * @param framed the pixels of the view that the picture is of
 * @param ratio width by height of a shot; null for that of the view
 */
export function pictureSizeOf(
  { size, width, height }: Pick<PictureSettings, 'size' | 'width' | 'height'>,
  framed: CaptureSize,
  ratio: number | null,
): CaptureSize {
  const aspect = ratio ?? framed.width / framed.height;
  switch (size) {
    case 'view':
      return { width: Math.round(framed.width), height: Math.round(framed.height) };
    case '1080p':
      return withShortSide(1080, aspect);
    case '4k':
      return withShortSide(2160, aspect);
    case 'a4':
      return withShortSide(
        Math.min(sheet.short, sheet.long * Math.min(aspect, 1 / aspect)),
        aspect,
      );
    case 'free':
      return { width, height: ratio === null ? height : Math.max(1, Math.round(width / ratio)) };
  }
}

function withShortSide(side: number, aspect: number): CaptureSize {
  return {
    width: Math.round(side * Math.max(1, aspect)),
    height: Math.round(side * Math.max(1, 1 / aspect)),
  };
}
