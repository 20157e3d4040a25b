import { bytesOf, type TgaHeader } from './tga-header.ts';

/**
 * Writes the pixel that is stored at a byte offset as four bytes RGBA; returns false if its index
 * is not in the color map. The caller has checked that its bytes exist.
 */
export type PixelReader = (from: number, out: Uint8ClampedArray, at: number) => boolean;

/** Returns the function that reads the file's pixels. */
export function pixelReader(bytes: Uint8Array, header: TgaHeader): PixelReader {
  const { kind, pixelBits, pixelSize, hasAlphaBit, list } = header;
  if (kind === 'gray') return readGray;
  if (!list) return colorReader(bytes, pixelBits, hasAlphaBit);
  const { first, count, bits, start } = list;
  const readColor = colorReader(bytes, bits, hasAlphaBit);
  return (from, out, at) => {
    const number = bytes[from]! | (pixelSize > 1 ? bytes[from + 1]! << 8 : 0);
    const index = number - first;
    return index >= 0 && index < count && readColor(start + index * bytesOf(bits), out, at);
  };

  /** In 16 bits, the first byte is gray and the second is alpha. */
  function readGray(from: number, out: Uint8ClampedArray, at: number): boolean {
    const gray = bytes[from]!;
    return put(out, at, gray, gray, gray, pixelSize > 1 ? bytes[from + 1]! : 255);
  }
}

/** Blue comes first; each channel has five bits or a byte. */
function colorReader(bytes: Uint8Array, bits: number, hasAlphaBit: boolean): PixelReader {
  if (bits > 16) {
    return (from, out, at) => {
      const alpha = bits === 32 ? bytes[from + 3]! : 255;
      return put(out, at, bytes[from + 2]!, bytes[from + 1]!, bytes[from]!, alpha);
    };
  }
  const five = (value: number, shift: number): number => (((value >> shift) & 31) * 255) / 31;
  return (from, out, at) => {
    const value = bytes[from]! | (bytes[from + 1]! << 8);
    const alpha = bits === 16 && hasAlphaBit && value < 0x8000 ? 0 : 255;
    return put(out, at, five(value, 10), five(value, 5), five(value, 0), alpha);
  };
}

function put(
  out: Uint8ClampedArray,
  at: number,
  red: number,
  green: number,
  blue: number,
  alpha: number,
): true {
  out[at] = red;
  out[at + 1] = green;
  out[at + 2] = blue;
  out[at + 3] = alpha;
  return true;
}
