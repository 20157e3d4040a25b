/** The header of a TGA, checked against the bytes of the file. */
export interface TgaHeader {
  readonly width: number;
  readonly height: number;
  readonly kind: 'listed' | 'color' | 'gray';
  readonly isPacked: boolean;
  /** Bits and bytes of a stored pixel. */
  readonly pixelBits: number;
  readonly pixelSize: number;
  /** Whether the 16th bit is alpha. */
  readonly hasAlphaBit: boolean;
  readonly fromTop: boolean;
  readonly fromRight: boolean;
  /** Offset of the first pixel, in bytes. */
  readonly pixelStart: number;
  readonly list: ColorList | null;
}

/** The color map into which pixels are indices. */
export interface ColorList {
  /** The index of its first color. */
  readonly first: number;
  readonly count: number;
  readonly bits: number;
  readonly start: number;
}

const headerSize = 18;
const kinds = { 1: 'listed', 2: 'color', 3: 'gray' } as const;
const bitsOf: Readonly<Record<TgaHeader['kind'], readonly number[]>> = {
  listed: [8, 16],
  color: [15, 16, 24, 32],
  gray: [8, 16],
};
/** A run-length packet with one byte more than a pixel holds at most this many pixels. */
const longestRun = 128;

/** @returns the header, or what is wrong if the file is not a TGA or was cut short */
export function readTgaHeader(bytes: Uint8Array, pixelLimit: number): TgaHeader | string {
  if (bytes.length < headerSize) return `${bytes.length} bytes, fewer than a TGA’s header`;
  const u16 = (at: number): number => bytes[at]! | (bytes[at + 1]! << 8);
  const [idLength, listType, type] = [bytes[0]!, bytes[1]!, bytes[2]!];
  const [bits, flags] = [bytes[16]!, bytes[17]!];
  const kind = kinds[(type & 7) as 1 | 2 | 3] as TgaHeader['kind'] | undefined;
  const isPacked = (type & 8) !== 0;
  if (!kind || type > 11) return `a TGA of type ${type}`;
  if (listType > 1) return `a TGA whose list of colors is of type ${listType}`;
  if (!bitsOf[kind].includes(bits)) return `a TGA of type ${type} with ${bits} bits a pixel`;
  const [width, height] = [u16(12), u16(14)];
  const pixelCount = width * height;
  if (pixelCount === 0) return `a picture of ${width} × ${height} pixels`;
  if (pixelCount > pixelLimit) return `${width} × ${height} pixels, more than ${pixelLimit}`;

  const list = { first: u16(3), count: u16(5), bits: bytes[7]!, start: headerSize + idLength };
  const listSize = listType === 1 ? list.count * bytesOf(list.bits) : 0;
  if (kind === 'listed' && (listSize === 0 || !bitsOf.color.includes(list.bits))) {
    return `a list of ${list.count} colors of ${list.bits} bits`;
  }
  const pixelStart = list.start + listSize;
  const pixelSize = bytesOf(bits);
  const least = isPacked
    ? Math.ceil(pixelCount / longestRun) * (pixelSize + 1)
    : pixelCount * pixelSize;
  const left = bytes.length - pixelStart;
  if (left < least) {
    return `${Math.max(left, 0)} bytes for ${width} × ${height} pixels, at least ${least} are needed`;
  }
  return {
    width,
    height,
    kind,
    isPacked,
    pixelBits: bits,
    pixelSize,
    hasAlphaBit: (flags & 15) > 0,
    fromTop: (flags & 32) !== 0,
    fromRight: (flags & 16) !== 0,
    pixelStart,
    list: kind === 'listed' ? list : null,
  };
}

export function bytesOf(bits: number): number {
  return Math.ceil(bits / 8);
}
