import { GIFEncoder } from 'gifenc/dist/gifenc.esm.js';
import type { MovieSource } from '../../view/movie/movie-source.ts';
import { gifDelay } from './gif-delays.ts';
import { type GifPalette, PaletteSamples } from './gif-palette.ts';
import type { OpenSink } from './movie-format.ts';

/** As many frames, spread evenly, decide which colors all of them have. */
const sampleFrames = 12;

/** Writes a GIF that repeats for ever, with one palette for all frames. */
export const openGif: OpenSink = async (source) => {
  const { rate, size } = source.plan;
  const palette = await paletteOf(source);
  const encoder = GIFEncoder({ auto: false });
  let parts: Blob[] = [];
  const settle = (): void => {
    parts.push(new Blob([encoder.bytes()]));
    encoder.reset();
  };
  return {
    async add(frame) {
      const first = frame.index === 0;
      if (first) encoder.writeHeader();
      encoder.writeFrame(palette.indicesOf(await frame.picture()), size.width, size.height, {
        first,
        palette: first ? palette.colors : null,
        delay: 10 * gifDelay(frame.index, rate),
        transparent: palette.clear >= 0,
        transparentIndex: Math.max(0, palette.clear),
        repeat: 0,
      });
      settle();
    },
    finish() {
      encoder.finish();
      settle();
      return Promise.resolve(new Blob(parts, { type: 'image/gif' }));
    },
    close: () => void (parts = []),
  };
};

async function paletteOf(source: MovieSource): Promise<GifPalette> {
  const { count, background } = source.plan;
  const taken = Math.min(sampleFrames, count);
  const samples = new PaletteSamples(taken);
  for (let i = 0; i < taken; i++) {
    const index = taken === 1 ? 0 : Math.round((i * (count - 1)) / (taken - 1));
    const frame = await source.frame(index);
    samples.add(await frame.picture());
  }
  return samples.palette(!background);
}
