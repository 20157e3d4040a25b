import fc from 'fast-check';
import { expect, it } from 'vitest';
import { averageSamples } from '../../../src/view/picture/average-samples.ts';

const byte = fc.nat(255);
const pixel = fc.tuple(byte, byte, byte, fc.oneof(byte, fc.constantFrom(0, 255)));

const clear: [number, number, number, number] = [0, 0, 0, 0];

/** As GL blends on transparent black: colors are multiplied by their alpha. */
const premultiplied = (pixels: readonly (readonly number[])[]): Uint8Array =>
  Uint8Array.from(
    pixels.flatMap(([r, g, b, a]) => [...[r!, g!, b!].map((c) => Math.round((c * a!) / 255)), a!]),
  );

const linear = (c: number): number => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
const encoded = (c: number): number =>
  c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055;

it('a pixel has the mean light of its samples, weighted by alpha', () => {
  const squares = fc
    .integer({ min: 2, max: 4 })
    .chain((count) => fc.array(pixel, { minLength: count ** 2, maxLength: count ** 2 }));
  fc.assert(
    fc.property(squares, (square) => {
      const count = Math.sqrt(square.length);
      const pixels = premultiplied(square);
      const goal = { width: 1, height: 1, pixels: new Uint8ClampedArray(4) };
      averageSamples({ width: count, height: count, pixels }, count, goal, 0, 0);
      const alphas = square.reduce((sum, [, , , a]) => sum + a, 0);
      expect(Math.abs(goal.pixels[3]! - alphas / square.length)).toBeLessThanOrEqual(0.5);
      if (alphas === 0) return;
      for (let channel = 0; channel < 3; channel++) {
        const light = square.reduce((sum, [, , , a], at) => {
          const straight =
            a === 0 ? 0 : Math.min(255, Math.round((pixels[at * 4 + channel]! * 255) / a));
          return sum + a * linear(straight / 255);
        }, 0);
        const expected = encoded(light / alphas) * 255;
        expect(Math.abs(goal.pixels[channel]! - expected)).toBeLessThanOrEqual(0.6);
      }
    }),
    // Without its alpha, the second red is half between two bytes.
    { examples: [[[clear, [247, 1, 212, 210], clear, [111, 0, 88, 255]]]] },
  );
});

it('a field of one color keeps it, whatever the number of samples', () => {
  for (let value = 0; value < 256; value++) {
    const pixels = new Uint8Array(16).map((_, at) => (at % 4 === 3 ? 255 : value));
    const goal = { width: 1, height: 1, pixels: new Uint8ClampedArray(4) };
    averageSamples({ width: 2, height: 2, pixels }, 2, goal, 0, 0);
    expect([...goal.pixels]).toEqual([value, value, value, 255]);
  }
});

it('half black and half white is the gray of half the light, not half the byte', () => {
  const pixels = Uint8Array.from([0, 255, 255, 0].flatMap((c) => [c, c, c, 255]));
  const goal = { width: 1, height: 1, pixels: new Uint8ClampedArray(4) };
  averageSamples({ width: 2, height: 2, pixels }, 2, goal, 0, 0);
  expect(goal.pixels[0]).toBe(188);
});

it('samples land at their place, with the bottom row last', () => {
  const goal = { width: 3, height: 3, pixels: new Uint8ClampedArray(36) };
  const pixels = premultiplied([1, 2, 3, 4].map((c) => [c, c, c, 255]));
  averageSamples({ width: 2, height: 2, pixels }, 1, goal, 1, 0);
  expect(Array.from({ length: 9 }, (_, at) => goal.pixels[at * 4])).toEqual([
    0, 0, 0, 0, 3, 4, 0, 1, 2,
  ]);
});
