import { quantize } from 'gifenc/dist/gifenc.esm.js';
import type { Picture } from '../../view/picture/encode-picture.ts';

type Color = readonly [red: number, green: number, blue: number];

/** Pixels that show less than half of their color are transparent. */
const leastAlpha = 128;
/** Bits of each channel by which colors are told apart when they are looked up. */
const bits = 6;
/** All pictures together give about as many pixels to choose colors by. */
const samplePixels = 2 ** 18;
const mostColors = 256;

/** Gathers pixels of several pictures, spread evenly over each. */
export class PaletteSamples {
  private readonly pixels: number[] = [];
  private readonly each: number;

  /** @param pictures how many will be added */
  constructor(pictures: number) {
    this.each = samplePixels / pictures;
  }

  add({ pixels }: Picture): void {
    const count = pixels.length / 4;
    const step = Math.max(1, count / this.each);
    for (let at = 0; at < count; at += step) {
      const first = Math.floor(at) * 4;
      if (pixels[first + 3]! < leastAlpha) continue;
      for (let i = 0; i < 3; i++) this.pixels.push(pixels[first + i]!);
      this.pixels.push(255);
    }
  }

  /**
   * Returns the palette of all pictures. The last of 256 places is that of transparent pixels, if
   * there may be any.
   */
  palette(isTransparent: boolean): GifPalette {
    const count = isTransparent ? mostColors - 1 : mostColors;
    const colors: Color[] =
      this.pixels.length === 0 ? [] : quantize(Uint8Array.from(this.pixels), count);
    return new GifPalette(colors.length === 0 ? [[0, 0, 0]] : colors, isTransparent);
  }
}

/**
 * The colors of all frames. A color has one place in it, whatever the frame, so that what stands still
 * does not flicker.
 */
export class GifPalette {
  /** As they are written, with a place for transparent pixels. */
  readonly colors: readonly Color[];
  /** The place of transparent pixels, or −1. */
  readonly clear: number;
  /** The place of each color by `bits` of its channels; found when it is first needed. */
  private readonly places = new Int16Array(2 ** (3 * bits)).fill(-1);
  private readonly opaque: readonly Color[];

  constructor(opaque: readonly Color[], isTransparent: boolean) {
    this.opaque = opaque;
    this.clear = isTransparent ? opaque.length : -1;
    this.colors = isTransparent ? [...opaque, [0, 0, 0]] : opaque;
  }

  /** Returns the place of each pixel's color. */
  indicesOf({ pixels }: Picture): Uint8Array {
    const indices = new Uint8Array(pixels.length / 4);
    const down = 8 - bits;
    for (let pixel = 0, at = 0; pixel < indices.length; pixel++, at += 4) {
      if (this.clear >= 0 && pixels[at + 3]! < leastAlpha) {
        indices[pixel] = this.clear;
        continue;
      }
      const [red, green, blue] = [
        pixels[at]! >> down,
        pixels[at + 1]! >> down,
        pixels[at + 2]! >> down,
      ];
      const key = (((red << bits) | green) << bits) | blue;
      if (this.places[key]! < 0) this.places[key] = this.nearest(red, green, blue);
      indices[pixel] = this.places[key]!;
    }
    return indices;
  }

  /** The nearest color to the middle of those that begin with these bits. */
  private nearest(red: number, green: number, blue: number): number {
    const size = 2 ** (8 - bits);
    const middle = (channel: number): number => channel * size + (size - 1) / 2;
    const [r, g, b] = [middle(red), middle(green), middle(blue)];
    let [best, least] = [0, Infinity];
    for (const [index, color] of this.opaque.entries()) {
      const distance = (color[0] - r) ** 2 + (color[1] - g) ** 2 + (color[2] - b) ** 2;
      if (distance < least) [best, least] = [index, distance];
    }
    return best;
  }
}
