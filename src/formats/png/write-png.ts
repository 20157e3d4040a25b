import { zlibSync } from 'fflate';
import { pngChunk, pngSignature } from './text-chunk.ts';

/** Pixels of whole numbers, the top row first. */
export interface PngPixels {
  readonly width: number;
  readonly height: number;
  /** 16 bits of gray, or 8 bits of red, green and blue. */
  readonly kind: 'gray16' | 'rgb8';
  /** (height × width × bytes of a pixel), 16 bits with the high byte first. */
  readonly bytes: Uint8Array;
}

const kinds = {
  gray16: { bitDepth: 16, colorType: 0, pixelBytes: 2 },
  rgb8: { bitDepth: 8, colorType: 2, pixelBytes: 3 },
} as const;

/** Each row is stored as its difference to the row above it (filter 2, 9.2). */
const filterUp = 2;

/**
 * Writes a PNG (third edition) with exactly these numbers, which a canvas could not keep: it has 8
 * bits a channel.
 */
export function writePng({ width, height, kind, bytes }: PngPixels): Uint8Array {
  const { bitDepth, colorType, pixelBytes } = kinds[kind];
  const stride = width * pixelBytes;
  const rows = new Uint8Array(height * (stride + 1));
  for (let y = 0, at = 0; y < height; y++) {
    rows[at++] = filterUp;
    const [here, above] = [y * stride, (y - 1) * stride];
    for (let x = 0; x < stride; x++) {
      rows[at++] = bytes[here + x]! - (y > 0 ? bytes[above + x]! : 0);
    }
  }
  const header = new Uint8Array(13);
  const view = new DataView(header.buffer);
  view.setUint32(0, width);
  view.setUint32(4, height);
  header.set([bitDepth, colorType], 8);
  const parts = [
    Uint8Array.from(pngSignature),
    pngChunk('IHDR', header),
    pngChunk('IDAT', zlibSync(rows, { level: 4 })),
    pngChunk('IEND', new Uint8Array(0)),
  ];
  const png = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    png.set(part, at);
    at += part.length;
  }
  return png;
}
