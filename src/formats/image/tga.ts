import { readTgaHeader, type TgaHeader } from './tga-header.ts';
import { type PixelReader, pixelReader } from './tga-pixels.ts';

/** The pixels of a decoded image. */
export interface DecodedImage {
  readonly width: number;
  readonly height: number;
  /** (width × height × 4) RGBA, sRGB, alpha not premultiplied, the bottom row first. */
  readonly pixels: Uint8ClampedArray<ArrayBuffer>;
}

/** The largest accepted number of pixels: 8192 × 4096. */
const defaultPixelLimit = 2 ** 25;

/**
 * Decodes a Truevision TGA (types 1, 2, 3 and, run-length encoded, 9, 10, 11; 8, 15, 16, 24 and 32
 * bits; any corner as origin). Browsers do not decode TGA. Data after the pixels is ignored.
 *
 * @returns the image, or what is wrong with it
 */
export function decodeTga(
  bytes: Uint8Array,
  pixelLimit = defaultPixelLimit,
): DecodedImage | string {
  const header = readTgaHeader(bytes, pixelLimit);
  if (typeof header === 'string') return header;
  const read = pixelReader(bytes, header);
  const { width, height } = header;
  const pixels = new Uint8ClampedArray(width * height * 4);
  const fault = header.isPacked ? unpack(bytes, header, read, pixels) : copy(header, read, pixels);
  if (fault !== null) return fault;
  if (header.pixelSize === 4) fillUnsetAlpha(pixels);
  return { width, height, pixels };
}

/** Copies uncompressed pixels, whose bytes the header check has shown to exist. */
function copy(header: TgaHeader, read: PixelReader, pixels: Uint8ClampedArray): string | null {
  const { pixelStart, pixelSize, width, height } = header;
  for (let index = 0; index < width * height; index++) {
    const from = pixelStart + index * pixelSize;
    if (!read(from, pixels, targetOf(header, index))) return colorFault(index);
  }
  return null;
}

/**
 * Decodes packets of up to 128 pixels: literal pixels, or one pixel that is repeated. Packets may
 * continue across the end of a row.
 */
function unpack(
  bytes: Uint8Array,
  header: TgaHeader,
  read: PixelReader,
  pixels: Uint8ClampedArray,
): string | null {
  const { pixelStart, pixelSize, width, height } = header;
  const count = width * height;
  let at = pixelStart;
  let index = 0;
  while (index < count) {
    const packet = bytes[at++];
    if (packet === undefined) return `the end of the file after ${index} of ${count} pixels`;
    const isRun = packet >= 128;
    const length = Math.min((packet & 127) + 1, count - index);
    const size = isRun ? pixelSize : length * pixelSize;
    if (at + size > bytes.length) return `the end of the file after ${index} of ${count} pixels`;
    for (let i = 0; i < length; i++) {
      const from = isRun ? at : at + i * pixelSize;
      if (!read(from, pixels, targetOf(header, index + i))) return colorFault(index + i);
    }
    at += size;
    index += length;
  }
  return null;
}

/** Where a pixel of the file goes in the image, whose first row is the bottom one. */
function targetOf({ width, height, fromTop, fromRight }: TgaHeader, index: number): number {
  const row = Math.floor(index / width);
  const column = index % width;
  const y = fromTop ? height - 1 - row : row;
  return (y * width + (fromRight ? width - 1 - column : column)) * 4;
}

function colorFault(index: number): string {
  return `a color that is not in the picture’s list, pixel ${index}`;
}

/**
 * Programs that write 32 bits without alpha leave it 0, so an image that is fully transparent is
 * made opaque.
 */
function fillUnsetAlpha(pixels: Uint8ClampedArray): void {
  for (let at = 3; at < pixels.length; at += 4) if (pixels[at] !== 0) return;
  for (let at = 3; at < pixels.length; at += 4) pixels[at] = 255;
}
