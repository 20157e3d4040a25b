import { encodedChannel } from '../../core/oklab.ts';
import { linearChannel } from '../theme.ts';

/** Pixels of RGBA as GL gives them: the bottom row first, and colors multiplied by their alpha. */
export interface Samples {
  readonly width: number;
  readonly height: number;
  readonly pixels: Uint8Array;
}

/** Columns of a picture, in its pixels from its left edge. */
interface Columns {
  readonly x: number;
  readonly width: number;
}

/** A picture that is being put together: RGBA with alpha not multiplied in, the top row first. */
export interface PixelGoal {
  readonly width: number;
  readonly height: number;
  readonly pixels: Uint8ClampedArray<ArrayBuffer>;
}

/**
 * Writes the mean of each square of samples into a pixel. Light is added up in linear light, weighted
 * by its alpha, as a lens would (Glassner 1995, 5.3: the box filter). With one sample a pixel nothing
 * is converted, so that the picture has the bytes of the view.
 *
 * @param count of samples on each side of a pixel
 * @param left, bottom where the samples begin in the goal, in its pixels from its lower left corner
 * @param clip the columns of the goal that are written
 */
export function averageSamples(
  { width, height, pixels }: Samples,
  count: number,
  goal: PixelGoal,
  left: number,
  bottom: number,
  clip: Columns = { x: left, width: width / count },
): void {
  const first = Math.max(0, clip.x - left);
  const end = Math.min(width / count, clip.x + clip.width - left);
  for (let row = 0; row < height / count; row++) {
    let at = ((goal.height - 1 - bottom - row) * goal.width + left + first) * 4;
    for (let column = first; column < end; column++, at += 4) {
      const sample = (row * count * width + column * count) * 4;
      if (count === 1) copyPixel(pixels, sample, goal.pixels, at);
      else meanOfSquare(pixels, sample, width, count, goal.pixels, at);
    }
  }
}

function copyPixel(from: Uint8Array, at: number, to: Uint8ClampedArray, goal: number): void {
  const alpha = from[at + 3]!;
  const factor = alpha === 0 ? 1 : 255 / alpha;
  for (let channel = 0; channel < 3; channel++) to[goal + channel] = from[at + channel]! * factor;
  to[goal + 3] = alpha;
}

function meanOfSquare(
  from: Uint8Array,
  first: number,
  stride: number,
  count: number,
  to: Uint8ClampedArray,
  goal: number,
): void {
  let [red, green, blue, alphas] = [0, 0, 0, 0];
  for (let y = 0; y < count; y++) {
    for (let x = 0; x < count; x++) {
      const at = first + (y * stride + x) * 4;
      const alpha = from[at + 3]!;
      if (alpha === 0) continue;
      // The product comes first, so that a color half between two bytes is exactly there.
      red += alpha * linearOf((from[at]! * 255) / alpha);
      green += alpha * linearOf((from[at + 1]! * 255) / alpha);
      blue += alpha * linearOf((from[at + 2]! * 255) / alpha);
      alphas += alpha;
    }
  }
  const weight = alphas === 0 ? 0 : 1 / alphas;
  to[goal] = encodedOf(red * weight);
  to[goal + 1] = encodedOf(green * weight);
  to[goal + 2] = encodedOf(blue * weight);
  to[goal + 3] = alphas / (count * count);
}

/** The linear light of each byte. */
const linearLight = Float64Array.from({ length: 256 }, (_, byte) => linearChannel(byte / 255));

function linearOf(byte: number): number {
  return linearLight[Math.min(255, Math.round(byte))]!;
}

/** Steps of linear light, fine enough that dark bytes, which are closest together, have several. */
const steps = 65_535;
/** (steps + 1) the byte of each step; made for the first picture that needs it. */
let encodedLight: Uint8Array | null = null;

function encodedOf(light: number): number {
  encodedLight ??= Uint8Array.from({ length: steps + 1 }, (_, step) =>
    Math.round(255 * encodedChannel(step / steps)),
  );
  return encodedLight[Math.round(light * steps)]!;
}
