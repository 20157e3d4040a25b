import { loadPart } from '../../core/failure.ts';
import type { MovieFormatId } from '../../view/movie/movie-settings.ts';
import { whyNoGif } from './gif-delays.ts';
import { always, type MovieFormat, pixelsOf } from './movie-format.ts';
import {
  bitsPerSecond,
  mp4Codecs,
  supportedCodec,
  webmCodecs,
  whyNoVideo,
} from './video-codecs.ts';

/** Bytes a pixel that pictures of characters took in each form; they only make the estimate. */
const bytesPerPixel = { png: 0.32, gif: 0.28 };
/** About what a point and its triangles take in a packed OBJ. */
const bytesPerObj = 150_000;

const videoBytes: MovieFormat['bytesOf'] = (plan) =>
  (bitsPerSecond(plan) / 8) * (plan.count / plan.rate);

/** Every form in which movies are saved, in the order of the choice. */
export const movieFormats: Readonly<Record<MovieFormatId, MovieFormat>> = {
  webm: {
    id: 'webm',
    label: 'WebM video',
    ending: '.webm',
    isTransparent: true,
    whyNot: (plan) => whyNoVideo(plan, webmCodecs, 'VP9 or VP8'),
    bytesOf: videoBytes,
    load: async () => {
      const { openVideo } = await loadPart(import('./video-file.ts'));
      return async (source) =>
        openVideo(source, 'webm', await supportedCodec(source.plan, webmCodecs));
    },
  },
  mp4: {
    id: 'mp4',
    label: 'MP4 video (H.264)',
    ending: '.mp4',
    isTransparent: false,
    whyNot: (plan) => whyNoVideo(plan, mp4Codecs, 'H.264'),
    bytesOf: videoBytes,
    load: async () => {
      const { openVideo } = await loadPart(import('./video-file.ts'));
      return async (source) =>
        openVideo(source, 'mp4', await supportedCodec(source.plan, mp4Codecs));
    },
  },
  gif: {
    id: 'gif',
    label: 'GIF',
    ending: '.gif',
    isTransparent: true,
    whyNot: (plan) => Promise.resolve(whyNoGif(plan)),
    bytesOf: (plan) => pixelsOf(plan) * bytesPerPixel.gif,
    load: async () => (await loadPart(import('./gif-file.ts'))).openGif,
  },
  png: {
    id: 'png',
    label: 'PNG sequence (zip)',
    ending: '-frames.zip',
    isTransparent: true,
    whyNot: always,
    bytesOf: (plan) => pixelsOf(plan) * bytesPerPixel.png,
    load: async () => (await loadPart(import('./png-sequence.ts'))).openPngSequence,
  },
  obj: {
    id: 'obj',
    label: 'OBJ sequence of the selected character (zip)',
    ending: '-meshes.zip',
    isTransparent: false,
    whyNot: always,
    bytesOf: ({ count }) => count * bytesPerObj,
    load: async () => (await loadPart(import('./obj-sequence.ts'))).openObjSequence,
  },
};
