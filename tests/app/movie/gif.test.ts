import { describe, expect, it } from 'vitest';
import { gifDelay, whyNoGif } from '../../../src/app/movie/gif-delays.ts';
import { openGif } from '../../../src/app/movie/gif-file.ts';
import { PaletteSamples } from '../../../src/app/movie/gif-palette.ts';
import { planOf, sourceOf } from './fake-source.ts';

/** The blocks of a GIF (GIF89a specification): its color tables and the controls of its frames. */
function blocksOf(bytes: Buffer) {
  const tableLength = (flags: number): number => (flags & 0x80 ? 3 * 2 ** ((flags & 7) + 1) : 0);
  const head = { width: bytes.readUInt16LE(6), height: bytes.readUInt16LE(8) };
  let at = 13 + tableLength(bytes[10]!);
  const delays: number[] = [];
  const clear: number[] = [];
  let [frames, tables] = [0, bytes[10]! & 0x80 ? 1 : 0];
  const skipBlocks = (): void => {
    while (bytes[at] !== 0) at += bytes[at]! + 1;
    at++;
  };
  while (bytes[at] !== 0x3b) {
    if (bytes[at] === 0x21) {
      if (bytes[at + 1] === 0xf9) {
        delays.push(bytes.readUInt16LE(at + 4));
        if (bytes[at + 3]! & 1) clear.push(bytes[at + 6]!);
      }
      at += 2;
    } else {
      expect(bytes[at]).toBe(0x2c);
      frames++;
      if (bytes[at + 9]! & 0x80) tables++;
      at += 11 + tableLength(bytes[at + 9]!);
    }
    skipBlocks();
  }
  expect(at).toBe(bytes.length - 1);
  return { ...head, frames, tables, delays, clear, palette: bytes.subarray(13, 13 + 768) };
}

const size = { width: 48, height: 32 };
/** Smooth colors that move from frame to frame, as shaded skin before a backdrop. */
const shaded = (frame: number, x: number, y: number) =>
  [120 + 2 * x, 60 + 4 * y + frame, 200 - 3 * x, 255] as const;

async function gifOf(...[plan, colorOf]: Parameters<typeof sourceOf>): Promise<Buffer> {
  const source = sourceOf(plan, colorOf);
  const sink = await openGif(source);
  for (let index = 0; index < plan.count; index++) await sink.add(await source.frame(index));
  return Buffer.from(await (await sink.finish()).arrayBuffer());
}

describe('a GIF', () => {
  it('has one palette for all frames, and repeats for ever', async () => {
    const plan = planOf({ ...size, format: 'gif', rate: 12 });
    const bytes = await gifOf(plan, shaded);
    expect(blocksOf(bytes)).toMatchObject({ ...size, frames: 24, tables: 1, clear: [] });
    expect(bytes.includes('NETSCAPE2.0\x03\x01\x00\x00')).toBe(true);
  });

  it('lasts as long as the movie, at every rate', async () => {
    for (const rate of [24, 25, 30, 50, 29.97]) {
      const delays = Array.from({ length: 600 }, (_, frame) => gifDelay(frame, rate));
      const sum = delays.reduce((a, b) => a + b);
      expect(Math.abs(sum - 60_000 / rate)).toBeLessThanOrEqual(0.5);
      expect(Math.min(...delays)).toBeGreaterThanOrEqual(2);
    }
    const plan = planOf({ ...size, format: 'gif', rate: 30, range: 'typed', from: 0, to: 0.2 });
    expect(blocksOf(await gifOf(plan, shaded)).delays).toEqual([3, 4, 3, 3, 4, 3]);
    expect(whyNoGif({ rate: 50 })).toBeNull();
    expect(whyNoGif({ rate: 60 })).toContain('at most 50');
  });

  it('has a place for what is transparent', async () => {
    const plan = planOf({ ...size, format: 'gif', background: false, rate: 5 });
    const bytes = await gifOf(plan, (frame, x, y) => (x < 10 ? [0, 0, 0, 0] : shaded(frame, x, y)));
    const { clear, frames } = blocksOf(bytes);
    expect(clear).toHaveLength(frames);
    expect(new Set(clear).size).toBe(1);
  });
});

describe('a palette', () => {
  it('has a color near each of the pictures, the same for every frame', async () => {
    const plan = planOf({ ...size, format: 'gif' });
    const source = sourceOf(plan, shaded);
    const pictures = await Promise.all(
      [0, 30, 59].map(async (index) => (await source.frame(index)).picture()),
    );
    const samples = new PaletteSamples(pictures.length);
    for (const picture of pictures) samples.add(picture);
    const palette = samples.palette(false);
    expect(palette.colors.length).toBeLessThanOrEqual(256);
    const errors = pictures.flatMap((picture) =>
      Array.from(palette.indicesOf(picture), (index, pixel) =>
        Math.max(
          ...palette.colors[index]!.map((value, i) =>
            Math.abs(value - picture.pixels[pixel * 4 + i]!),
          ),
        ),
      ),
    );
    // 256 colors for some 4,000: neighbors of a smooth picture differ by about 10 of 255.
    expect(Math.max(...errors)).toBeLessThan(32);
    expect(errors.reduce((a, b) => a + b) / errors.length).toBeLessThan(9);
    // A color that is in two frames has one place.
    const [first, again] = [0, 1].map(() => palette.indicesOf(pictures[0]!));
    expect(again).toEqual(first);
  });

  it('keeps few colors exactly', () => {
    const pixels = new Uint8ClampedArray(64 * 4);
    for (let at = 0; at < 64; at++)
      pixels.set(at % 2 ? [250, 10, 30, 255] : [10, 20, 200, 255], at * 4);
    const samples = new PaletteSamples(1);
    samples.add({ width: 8, height: 8, pixels });
    const palette = samples.palette(true);
    const indices = palette.indicesOf({ width: 8, height: 8, pixels });
    expect(palette.colors[indices[0]!]).toEqual([10, 20, 200]);
    expect(palette.colors[indices[1]!]).toEqual([250, 10, 30]);
  });

  it('holds for pictures of which all is transparent', () => {
    const samples = new PaletteSamples(1);
    const picture = { width: 2, height: 2, pixels: new Uint8ClampedArray(16) };
    samples.add(picture);
    const palette = samples.palette(true);
    expect([...palette.indicesOf(picture)]).toEqual(new Array(4).fill(palette.clear));
  });
});
