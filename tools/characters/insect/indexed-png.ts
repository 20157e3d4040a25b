import { deflateSync } from 'node:zlib';
import { crc32 } from '../../../src/formats/crc32.ts';

/**
 * A box of the color space with six bits per channel, and the number of pixels of each color in it.
 */
interface Box {
  readonly colors: readonly { readonly code: number; readonly count: number }[];
  readonly channel: number;
  /**
   * Computed from its extent along its longest channel and its number of pixels; the largest is cut
   * first.
   */
  readonly weight: number;
}

const bits = 6;
const channelOf = (code: number, channel: number): number =>
  (code >> (bits * (2 - channel))) & (2 ** bits - 1);

function codeOf(pixels: Uint8Array, at: number): number {
  const shift = 8 - bits;
  const [red, green, blue] = [pixels[at]!, pixels[at + 1]!, pixels[at + 2]!];
  return ((red >> shift) << (2 * bits)) | ((green >> shift) << bits) | (blue >> shift);
}

function boxOf(colors: Box['colors']): Box {
  const extents = [0, 1, 2].map((channel) => {
    const values = colors.map(({ code }) => channelOf(code, channel));
    const [low, high] = [Math.min(...values), Math.max(...values)];
    return high - low;
  });
  const longest = Math.max(...extents);
  const count = colors.reduce((sum, color) => sum + color.count, 0);
  return { colors, channel: extents.indexOf(longest), weight: longest ** 3 * count ** 0.6 };
}

/** Cuts a box into two halves with numbers of pixels as equal as its colors allow. */
function cut({ colors, channel }: Box): [Box, Box] {
  const sorted = colors.toSorted(
    (a, b) => channelOf(a.code, channel) - channelOf(b.code, channel) || a.code - b.code,
  );
  const half = sorted.reduce((sum, { count }) => sum + count, 0) / 2;
  let sum = 0;
  let at = 0;
  while (at < sorted.length - 1 && (at === 0 || sum < half)) sum += sorted[at++]!.count;
  return [boxOf(sorted.slice(0, at)), boxOf(sorted.slice(at))];
}

/** Divides the colors of a picture into at most this many boxes, by median cut (Heckbert 1982). */
function boxesOf(pixels: Uint8Array, most: number): Box[] {
  const counts = new Map<number, number>();
  for (let at = 0; at < pixels.length; at += 3) {
    const code = codeOf(pixels, at);
    counts.set(code, (counts.get(code) ?? 0) + 1);
  }
  const boxes = [boxOf([...counts].map(([code, count]) => ({ code, count })))];
  while (boxes.length < most) {
    boxes.sort((a, b) => b.weight - a.weight);
    if (boxes[0]!.weight === 0) break;
    boxes.push(...cut(boxes.shift()!));
  }
  return boxes;
}

function chunk(kind: string, content: Uint8Array): Buffer {
  const body = Buffer.concat([Buffer.from(kind, 'latin1'), content]);
  const [length, check] = [Buffer.alloc(4), Buffer.alloc(4)];
  length.writeUInt32BE(content.length);
  check.writeUInt32BE(crc32(body));
  return Buffer.concat([length, body, check]);
}

/**
 * Makes a PNG with a palette and one byte per pixel, which has a third of the size of a PNG with
 * full colors.
 *
 * @param pixels (size × size × 3) red, green, blue, row by row from the top
 * @param colors at most 256
 */
export function indexedPng(pixels: Uint8Array, size: number, colors: number): Buffer {
  const boxes = boxesOf(pixels, colors);
  const indexOf = new Map<number, number>();
  boxes.forEach((box, index) => {
    for (const { code } of box.colors) indexOf.set(code, index);
  });
  const sums = boxes.map(() => [0, 0, 0, 0] as [number, number, number, number]);
  // Each row begins with its filter type: 0 is none.
  const rows = Buffer.alloc((size + 1) * size);
  for (let pixel = 0; pixel < size * size; pixel++) {
    const index = indexOf.get(codeOf(pixels, pixel * 3))!;
    rows[Math.floor(pixel / size) * (size + 1) + 1 + (pixel % size)] = index;
    const sum = sums[index]!;
    for (let channel = 0; channel < 3; channel++) {
      sum[channel] = sum[channel]! + pixels[pixel * 3 + channel]!;
    }
    sum[3]++;
  }
  const header = Buffer.alloc(13);
  header.writeUInt32BE(size, 0);
  header.writeUInt32BE(size, 4);
  header.set([8, 3], 8);
  const table = sums.flatMap(([red, green, blue, count]) =>
    [red, green, blue].map((sum) => Math.round(sum / count)),
  );
  return Buffer.concat([
    Buffer.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a),
    chunk('IHDR', header),
    chunk('PLTE', Uint8Array.from(table)),
    chunk('IDAT', deflateSync(rows, { level: 9, memLevel: 9 })),
    chunk('IEND', new Uint8Array()),
  ]);
}
