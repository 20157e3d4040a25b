import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type DecodedImage, decodeTga } from '../../../src/formats/image/tga.ts';
import { ByteWriter } from '../../support/byte-writer.ts';
import { mutated } from '../../support/mutations.ts';

interface TgaContent {
  readonly type: number;
  readonly bits: number;
  readonly width?: number;
  readonly height?: number;
  readonly flags?: number;
  readonly id?: readonly number[];
  /** Bits per color of the color map, the index of its first color, and its bytes. */
  readonly list?: { readonly bits: number; readonly first: number; readonly bytes: number[] };
  readonly data: readonly number[];
}

function tga({ type, bits, width = 2, height = 2, flags = 0, id = [], list, data }: TgaContent) {
  const out = new ByteWriter();
  const count = list ? list.bytes.length / Math.ceil(list.bits / 8) : 0;
  out.u8(id.length, list ? 1 : 0, type).u16(list?.first ?? 0, count);
  out.u8(list?.bits ?? 0).u16(0, 0, width, height);
  return out.u8(bits, flags, ...id, ...(list?.bytes ?? []), ...data).done();
}

function decoded(content: TgaContent | Uint8Array): DecodedImage {
  const image = decodeTga(content instanceof Uint8Array ? content : tga(content));
  if (typeof image === 'string') throw new Error(image);
  return image;
}

/** The four bytes of each pixel, the bottom row first. */
function pixelsOf(content: TgaContent): number[][] {
  const { pixels } = decoded(content);
  return Array.from({ length: pixels.length / 4 }, (_, i) => [...pixels.slice(i * 4, i * 4 + 4)]);
}

const [red, green, blue, white] = [
  [255, 0, 0, 255],
  [0, 255, 0, 255],
  [0, 0, 255, 255],
  [255, 255, 255, 255],
];
/** In the file's order: blue, green, red. */
const [storedRed, storedGreen, storedBlue, storedWhite] = [
  [0, 0, 255],
  [0, 255, 0],
  [255, 0, 0],
  [255, 255, 255],
];
const four = [storedRed, storedGreen, storedBlue, storedWhite].flatMap((stored) => stored);
const fromTop = 32;
const fromRight = 16;

/** One of every type. */
const samples: Readonly<Record<string, TgaContent>> = {
  'colors of a list': {
    ...{ type: 1, bits: 8, list: { bits: 24, first: 3, bytes: four }, id: [1, 2, 3] },
    data: [3, 4, 5, 6],
  },
  'colors of a long list': {
    ...{ type: 1, bits: 16, list: { bits: 32, first: 300, bytes: [0, 0, 255, 9, 0, 255, 0, 255] } },
    data: [44, 1, 45, 1, 45, 1, 44, 1],
  },
  '24 bits': { type: 2, bits: 24, data: four },
  '16 bits': { type: 2, bits: 16, data: [0x00, 0x7c, 0xe0, 0x83, 0x1f, 0, 0xff, 0x7f], flags: 1 },
  gray: { type: 3, bits: 8, data: [0, 100, 200, 255] },
  'colors of a list, packed': {
    ...{ type: 9, bits: 8, list: { bits: 16, first: 0, bytes: [0x00, 0x7c, 0xff, 0x7f] } },
    data: [0x82, 0, 0x00, 1],
  },
  '32 bits, packed': { type: 10, bits: 32, data: [0x82, 0, 0, 255, 128, 0x00, 255, 0, 0, 7] },
  'gray, packed': { type: 11, bits: 8, data: [0x00, 9, 0x82, 77] },
};

describe('TGA', () => {
  it('has blue first, and the first row at the bottom', () => {
    expect(pixelsOf(samples['24 bits']!)).toEqual([red, green, blue, white]);
  });

  it.each([
    ['from the top', fromTop, [blue, white, red, green]],
    ['from the right', fromRight, [green, red, white, blue]],
    ['from the top right', fromTop + fromRight, [white, blue, green, red]],
  ] as const)('may be stored %s', (_, flags, expected) => {
    expect(pixelsOf({ ...samples['24 bits']!, flags })).toEqual(expected);
  });

  it('has 5 bits per channel in 15 and 16 bits, and an alpha bit if the header says so', () => {
    const sixteen = samples['16 bits']!;
    expect(pixelsOf({ ...sixteen, bits: 15 })).toEqual([red, green, blue, white]);
    expect(pixelsOf({ ...sixteen, flags: 0 })).toEqual([red, green, blue, white]);
    expect(pixelsOf(sixteen).map(([, , , alpha]) => alpha)).toEqual([0, 255, 0, 0]);
    expect(pixelsOf({ type: 2, bits: 16, width: 1, height: 1, data: [0x10, 0x42] })).toEqual([
      [132, 132, 132, 255],
    ]);
  });

  it('has alpha in 32 bits, unless it is 0 everywhere', () => {
    const pixel = (alpha: number): number[] => [1, 2, 3, alpha];
    const image = { type: 2, bits: 32, width: 2, height: 1 };
    expect(pixelsOf({ ...image, data: [...pixel(0), ...pixel(9)] })).toEqual([
      [3, 2, 1, 0],
      [3, 2, 1, 9],
    ]);
    expect(pixelsOf({ ...image, data: [...pixel(0), ...pixel(0)] })).toEqual([
      [3, 2, 1, 255],
      [3, 2, 1, 255],
    ]);
  });

  it('has a color map, whose first color has an index of its own', () => {
    expect(pixelsOf(samples['colors of a list']!)).toEqual([red, green, blue, white]);
    expect(pixelsOf(samples['colors of a long list']!)).toEqual([
      [255, 0, 0, 9],
      green,
      green,
      [255, 0, 0, 9],
    ]);
    expect(pixelsOf(samples['colors of a list, packed']!)).toEqual([red, red, red, white]);
  });

  it('skips a color map that is not used', () => {
    const list = { bits: 24, first: 0, bytes: [9, 9, 9] };
    expect(pixelsOf({ ...samples['24 bits']!, list })).toEqual([red, green, blue, white]);
  });

  it('has gray, and gray with alpha', () => {
    expect(pixelsOf(samples['gray']!)[1]).toEqual([100, 100, 100, 255]);
    expect(pixelsOf({ type: 3, bits: 16, width: 1, height: 1, data: [50, 60] })).toEqual([
      [50, 50, 50, 60],
    ]);
    expect(pixelsOf(samples['gray, packed']!).map(([gray]) => gray)).toEqual([9, 77, 77, 77]);
  });

  it('has packets that continue across rows, and beyond the end', () => {
    const half = [128, 0, 255, 128];
    expect(pixelsOf(samples['32 bits, packed']!)).toEqual([
      ...[0, 1, 2].map(() => [255, 0, 0, 128]),
      [0, 0, 255, 7],
    ]);
    const over = { ...samples['32 bits, packed']!, data: [0xff, 255, 0, 128, 128] };
    expect(pixelsOf(over)).toEqual([half, half, half, half]);
  });

  it('may be followed by other data', () => {
    const bytes = tga(samples['24 bits']!);
    expect(decoded(Uint8Array.of(...bytes, 1, 2, 3))).toEqual(decoded(bytes));
  });
});

describe('files that are not TGA, or not complete', () => {
  it.each(Object.entries(samples))('%s: cut at any byte it is told', (_, content) => {
    const bytes = tga(content);
    for (let end = 0; end < bytes.length; end++) {
      expect(decodeTga(bytes.subarray(0, end)), `${end} bytes`).toEqual(expect.any(String));
    }
  });

  it.each<[string, Partial<TgaContent>, RegExp]>([
    ['a type that there is not', { type: 32 }, /type 32$/],
    ['no image', { type: 0 }, /type 0$/],
    ['bits that there are not', { bits: 12 }, /12 bits a pixel/],
    ['no pixels', { width: 0 }, /0 × 2/],
    ['more pixels than bytes', { width: 5000, height: 5000 }, /at least 75000000 are needed/],
    ['more pixels than are taken', { width: 65535, height: 65535 }, /more than 33554432/],
    ['pixels of a list without one', { type: 1, bits: 8 }, /list of 0 colors/],
    [
      'a number that the list has not',
      {
        type: 1,
        bits: 8,
        list: { bits: 24, first: 1, bytes: four.slice(0, 9) },
        data: [1, 2, 4, 3],
      },
      /not in the picture’s list, pixel 2/,
    ],
    [
      'a color of odd bits',
      { type: 1, bits: 8, list: { bits: 8, first: 0, bytes: [1, 2, 3] } },
      /3 colors of 8 bits/,
    ],
  ])('%s is told', (_, change, message) => {
    expect(decodeTga(tga({ ...samples['24 bits']!, ...change }))).toMatch(message);
  });

  it('no allocation exceeds the limit of pixels', () => {
    const packed = tga({ ...samples['gray, packed']!, width: 64, height: 64 });
    expect(decodeTga(packed, 1000)).toMatch(/64 × 64 pixels, more than 1000/);
    expect(decodeTga(packed)).toMatch(/at least 64 are needed/);
  });

  it.each(Object.entries(samples))(
    '%s: 500 changed files give a picture or a word',
    (_, content) => {
      fc.assert(
        fc.property(mutated(tga(content), ['0', '9']), (bytes) => {
          const image = decodeTga(bytes, 100_000);
          if (typeof image === 'string') expect(image).not.toBe('');
          else expect(image.pixels).toHaveLength(image.width * image.height * 4);
        }),
        { numRuns: 500 },
      );
    },
  );
});
